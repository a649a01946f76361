// SPDX-License-Identifier: MIT
#include "scene/asset_path.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/errors.h"

namespace stagelight {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path &path) {
    std::error_code unimportant;  // what can't be asked is not there for us
    return fs::is_regular_file(path, unimportant);
}

// The scene's folder and those of STAGELIGHT_ASSETS.
std::vector<fs::path> own_folders(const fs::path &scene_folder) {
    std::vector<fs::path> folders{scene_folder.empty() ? fs::path(".") : scene_folder};
    const char *variable = std::getenv("STAGELIGHT_ASSETS");
    std::istringstream list(variable ? variable : "");
    for (std::string folder; std::getline(list, folder, ':');) {
        if (!folder.empty()) {
            folders.emplace_back(folder);
        }
    }
    return folders;
}

// The first by path, since the order of a folder's entries is the file system's whim.
std::optional<fs::path> find_below(const fs::path &folder, const fs::path &file_name) {
    std::optional<fs::path> first;
    std::error_code error;  // ends the walk where it strikes
    for (fs::recursive_directory_iterator
             entry(folder, fs::directory_options::skip_permission_denied, error),
         end;
         !error && entry != end; entry.increment(error)) {
        const fs::path &path = entry->path();
        if (path.filename() == file_name && (!first || path < *first) && is_file(path)) {
            first = path;
        }
    }
    return first;
}

bool has_file(const AssetPackage &package, const fs::path &file) {
    const bool lies_in_it =
        std::mismatch(package.folder.begin(), package.folder.end(), file.begin(), file.end()).first
        == package.folder.end();
    return lies_in_it
           || std::find(package.files.begin(), package.files.end(), file.filename().string())
                  != package.files.end();
}

std::string remedy(const fs::path &file, const std::vector<AssetPackage> &packages) {
    std::vector<std::string> missing;
    for (const AssetPackage &package : packages) {
        if (has_file(package, file)) {
            return fmt::format("; Debian's {0} has it: apt-get install {0}", package.name);
        }
        std::error_code unimportant;
        if (!fs::is_directory(package.folder, unimportant)) {
            missing.push_back(package.name);
        }
    }
    if (missing.empty()) {
        return "";
    }
    return fmt::format("; packages not installed that may have it: apt-get install {}",
                       fmt::join(missing, " "));
}

}  // namespace

const std::vector<AssetPackage> &debian_packages() {
    static const std::vector<AssetPackage> packages{
        {"assimp-testmodels",
         "/usr/share/assimp/models",
         {"Suzanne_248.blend", "SuzanneSubdiv_252.blend"}},
        {"glmark2-data", "/usr/share/glmark2", {"bunny.obj", "horse.3ds", "nasa1.png"}}};
    return packages;
}

fs::path find_asset(const std::string &name, const fs::path &scene_folder,
                    const SourceLocation &where, const std::vector<AssetPackage> &packages) {
    fs::path file(name);
    std::vector<std::string> searched;
    if (file.is_absolute()) {
        if (is_file(file)) {
            return file;
        }
        searched.push_back("that place");
    } else {
        for (const fs::path &folder : own_folders(scene_folder)) {
            if (is_file(folder / file)) {
                return folder / file;
            }
            searched.push_back(folder.string());
        }
        for (const AssetPackage &package : packages) {
            if (is_file(package.folder / file)) {
                return package.folder / file;
            }
            if (const auto found = find_below(package.folder, file.filename())) {
                return *found;
            }
            searched.push_back(package.folder.string());
        }
    }
    throw UserError(fmt::format("{}: no file '{}', expected it in {}{}", to_string(where), name,
                                fmt::join(searched, ", "), remedy(file, packages)));
}

}  // namespace stagelight

// SPDX-License-Identifier: MIT
#include "scene/companion_file.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

#include "scene/text.h"

namespace stagelight {

namespace fs = std::filesystem;

namespace {

constexpr int deepest = 3;                    // folders below a mesh's
constexpr std::size_t most_entries = 10'000;  // looked at below it

using Parts = std::vector<std::string>;  // of a path

enum class Case { exact, any };

bool is_file(const fs::path &path) {
    std::error_code unimportant;  // what can't be asked is not there for us
    return fs::is_regular_file(path, unimportant);
}

bool is_same(const std::string &one, const std::string &other, Case letter_case) {
    return letter_case == Case::exact ? one == other : lower_case(one) == lower_case(other);
}

// RFC 3986, section 2.1: "%20" is a space.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    while (!text.empty()) {
        unsigned char byte = 0;
        const char *const end = text.data() + 3;
        if (text.size() >= 3 && text[0] == '%'
            && std::from_chars(text.data() + 1, end, byte, 16).ptr == end && byte != 0) {
            decoded += static_cast<char>(byte);
            text.remove_prefix(3);
        } else {
            decoded += text[0];
            text.remove_prefix(1);
        }
    }
    return decoded;
}

Parts parts_of(const std::string &name) {
    Parts parts;
    std::istringstream stream(name);
    for (std::string part; std::getline(stream, part, '/');) {
        if (!part.empty() && part != ".") {
            parts.push_back(part);
        }
    }
    return parts;
}

// The name as it is, with slashes for backslashes, and decoded.
std::vector<Parts> spellings(const std::string &name) {
    const auto with_slashes = [](std::string text) {
        std::ranges::replace(text, '\\', '/');
        return text;
    };
    std::vector<Parts> spellings;
    for (const std::string &spelled :
         {name, with_slashes(name), with_slashes(percent_decoded(name))}) {
        if (Parts parts = parts_of(spelled);
            !parts.empty() && parts.back() != ".."
            && std::ranges::find(spellings, parts) == spellings.end()) {
            spellings.push_back(std::move(parts));
        }
    }
    return spellings;
}

// By name, since the order of a folder's entries is the file system's whim. None of more than
// `most_entries`.
std::vector<fs::directory_entry> entries_of(const fs::path &folder) {
    std::vector<fs::directory_entry> entries;
    std::error_code error;  // ends the list where it strikes
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        entries.push_back(*entry);
        if (entries.size() > most_entries) {
            return {};
        }
    }
    std::ranges::sort(entries);
    return entries;
}

std::vector<fs::path> named(const fs::path &folder, const std::string &part, Case letter_case) {
    if (letter_case == Case::exact || part == "..") {
        return {folder / part};
    }
    std::vector<fs::path> found;
    for (const fs::directory_entry &entry : entries_of(folder)) {
        if (is_same(entry.path().filename(), part, letter_case)) {
            found.push_back(entry.path());
        }
    }
    return found;
}

std::optional<fs::path> find_in(const fs::path &folder, const Parts &parts, Case letter_case) {
    std::vector<fs::path> found{folder.empty() ? fs::path(".") : folder};
    for (const std::string &part : parts) {
        std::vector<fs::path> next;
        for (const fs::path &path : found) {
            const std::vector<fs::path> here = named(path, part, letter_case);
            next.insert(next.end(), here.begin(), here.end());
        }
        found = std::move(next);
    }
    const auto file = std::ranges::find_if(found, is_file);
    return file == found.end() ? std::nullopt : std::optional(*file);
}

std::optional<fs::path> find_in_any(const std::vector<fs::path> &folders,
                                    const std::vector<Parts> &names, std::size_t last_parts) {
    for (const Case letter_case : {Case::exact, Case::any}) {
        for (const Parts &before :
             {Parts{}, Parts{"textures"}, Parts{"..", "textures"}, Parts{".."}}) {
            if (before == Parts{".."} && last_parts == 1) {
                break;  // a file next to the folder is too often another's
            }
            for (const fs::path &folder : folders) {
                for (const Parts &name : names) {
                    Parts parts = before;
                    parts.insert(parts.end(),
                                 name.end() - std::ptrdiff_t(std::min(last_parts, name.size())),
                                 name.end());
                    if (auto found = find_in(folder, parts, letter_case)) {
                        return found;
                    }
                }
            }
        }
    }
    return std::nullopt;
}

bool is_folder_to_search(const fs::directory_entry &entry) {
    std::error_code unimportant;
    return entry.is_directory(unimportant) && !entry.path().filename().string().starts_with('.');
}

std::optional<fs::path> find_among(const std::vector<fs::directory_entry> &entries,
                                   const std::vector<Parts> &names) {
    for (const Case letter_case : {Case::exact, Case::any}) {
        for (const Parts &name : names) {
            for (const fs::directory_entry &entry : entries) {
                if (is_same(entry.path().filename(), name.back(), letter_case)
                    && is_file(entry.path())) {
                    return entry.path();
                }
            }
        }
    }
    return std::nullopt;
}

std::optional<fs::path> find_below(const fs::path &folder, const std::vector<Parts> &names) {
    std::vector<fs::path> level{folder.empty() ? fs::path(".") : folder};
    std::size_t seen = 0;
    for (int depth = 0; depth <= deepest && seen <= most_entries; ++depth) {
        std::vector<fs::directory_entry> entries;
        for (const fs::path &each : level) {
            const std::vector<fs::directory_entry> here = entries_of(each);
            seen += here.size();
            if (seen <= most_entries) {
                entries.insert(entries.end(), here.begin(), here.end());
            }
        }
        if (auto found = find_among(entries, names)) {
            return found;
        }
        level.clear();
        for (const fs::directory_entry &entry : entries) {
            if (is_folder_to_search(entry)) {
                level.push_back(entry.path());
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<fs::path> find_spelled(const std::string &name, const fs::path &folder) {
    for (const Case letter_case : {Case::exact, Case::any}) {
        for (const Parts &parts : spellings(name)) {
            if (auto found = find_in(folder, parts, letter_case)) {
                return found;
            }
        }
    }
    return std::nullopt;
}

std::optional<fs::path> find_companion(const std::string &name,
                                       const std::vector<fs::path> &folders) {
    if (fs::path(name).is_absolute() && is_file(name)) {
        return name;
    }
    const std::vector<Parts> names = spellings(name);
    if (names.empty()) {
        return std::nullopt;
    }
    const auto longest =
        std::ranges::max_element(names, {}, [](const Parts &parts) { return parts.size(); });
    for (std::size_t last_parts = longest->size(); last_parts > 0; --last_parts) {
        if (auto found = find_in_any(folders, names, last_parts)) {
            return found;
        }
    }
    return find_below(folders.front(), names);
}

}  // namespace stagelight

// SPDX-License-Identifier: MIT
#include "device/kernel_source.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "scene/errors.h"

namespace stagelight {
namespace {

std::string read_from_disk(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad()) {
        throw UserError(fmt::format(
            "{}: can't be read; --kernels, or STAGELIGHT_KERNELS, expects a folder that holds "
            "kernels/ and stages/ as the repository does",
            file.string()));
    }
    return text;
}

class Expansion {
public:
    Expansion(const std::optional<std::filesystem::path> &checkout, const Methods &methods)
        : checkout_(checkout), methods_(methods) {}

    void append(const std::string &path) {
        if (!included_.insert(path).second && !path.ends_with(".inc")) {
            return;
        }
        text_ += fmt::format("#line 1 \"{}\"\n", path);
        std::istringstream lines(read(path));
        std::string line;
        int depth = 0;                 // of #if
        bool may_be_left_out = false;  // a module was included within: its #line holds there alone
        for (int number = 1; std::getline(lines, line); ++number) {
            const std::string next_line = fmt::format("#line {} \"{}\"\n", number + 1, path);
            if (const std::optional<std::string> module = included_module(line)) {
                append("kernels/" + chosen_file(*module).generic_string());
                text_ += next_line;
                may_be_left_out = depth > 0;
                continue;
            }
            text_ += line + '\n';
            depth += line.starts_with("#if") ? 1 : line.starts_with("#endif") ? -1 : 0;
            if (may_be_left_out && line.starts_with("#e")) {  // #else, #elif, #endif
                text_ += next_line;
                may_be_left_out = depth > 0;
            }
        }
    }

    std::string take() { return std::move(text_); }

private:
    static std::optional<std::string> included_module(const std::string &line) {
        constexpr std::string_view start = "#include \"";
        const std::size_t end = line.find('"', start.size());
        if (!line.starts_with(start) || end == std::string::npos) {
            return std::nullopt;
        }
        return line.substr(start.size(), end - start.size());
    }

    // Where the folder of a module is named after a kind of method, that of the chosen method.
    std::filesystem::path chosen_file(const std::filesystem::path &module) const {
        const auto chosen = methods_.find(module.parent_path().filename());
        return chosen == methods_.end() ? module : module.parent_path() / (chosen->second + ".cl");
    }

    std::string read(const std::string &path) const {
        if (checkout_) {
            return read_from_disk(*checkout_ / path);
        }
        const auto found = embedded_sources.find(path);
        if (found == embedded_sources.end()) {
            throw std::logic_error(path + ": no such kernel inside this program");
        }
        return found->second;
    }

    const std::optional<std::filesystem::path> &checkout_;
    const Methods &methods_;
    std::set<std::string> included_;
    std::string text_;
};

}  // namespace

std::optional<std::filesystem::path>
named_kernels(const std::optional<std::filesystem::path> &checkout) {
    const char *from_environment = std::getenv("STAGELIGHT_KERNELS");
    return checkout || from_environment == nullptr ? checkout : from_environment;
}

std::string kernel_source(const std::string &path,
                          const std::optional<std::filesystem::path> &checkout,
                          const Methods &methods) {
    const std::optional<std::filesystem::path> folder = named_kernels(checkout);
    Expansion expansion(folder, methods);
    expansion.append(path);
    return expansion.take();
}

}  // namespace stagelight

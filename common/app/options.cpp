// SPDX-License-Identifier: MIT
#include "app/options.h"

#include <algorithm>
#include <limits>
#include <system_error>

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>

#include "image/image_io.h"
#include "scene/errors.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

constexpr int most_samples = 65536;
constexpr int most_depth = 64;
constexpr int most_frames = 1000000;
constexpr double most_scale = 64;

std::pair<int, int> parse_size(const std::string &text) {
    int width = 0;
    int height = 0;
    const char *end = text.data() + text.size();
    const auto [after_width, width_error] = std::from_chars(text.data(), end, width);
    const bool has_x = width_error == std::errc() && after_width != end && *after_width == 'x';
    const auto [after_height, height_error] =
        std::from_chars(has_x ? after_width + 1 : end, end, height);
    if (!has_x || height_error != std::errc() || after_height != end || width < 1 || height < 1
        || width > largest_image_size || height > largest_image_size) {
        throw UserError(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, 1 to {} each",
                                    text, largest_image_size));
    }
    return {width, height};
}

// Of a number that is one: CLI::Range lets NaN through, and prints 309 digits of the smallest.
CLI::Validator within(double least, double most) {
    const auto check = [=](const std::string &text) -> std::string {
        double value = 0;
        const char *end = text.data() + text.size();
        const auto [after, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc() && after == end && value >= least && value <= most) {
            return "";
        }
        return least < 1 ? fmt::format("{}: expected a number above 0, at most {}", text, most)
                         : fmt::format("{}: expected a number from {} to {}", text, least, most);
    };
    return {check, "", ""};
}

// Each file that is written is another than the rest, and none is the scene.
void require_distinct_files(const Options &options) {
    const auto place_of = [](const std::filesystem::path &file) {
        std::error_code ignored;  // a file that can't be looked at is told of when it is used
        return weakly_canonical(absolute(file, ignored), ignored);
    };
    const std::pair<const char *, std::optional<std::filesystem::path>> files[] = {
        {"the scene", options.scene},
        {"--out", options.out},
        {"--stats", options.stats},
        {"--export-pov", options.export_pov}};
    for (const auto &[name, file] : files) {
        for (const auto &[before, other] : files) {
            if (before == name) {
                break;
            }
            if (file && other && place_of(*file) == place_of(*other)) {
                throw UserError(fmt::format("{} {}: {} is the same file, expected another", name,
                                            file->string(), before));
            }
        }
    }
}

// A line for each method of a stage, the default of its kind first.
std::string list_methods(int stage) {
    std::string list;
    std::string kind;
    for (const Method &method : methods_of(stage)) {
        const std::string choice = method.kind + '=' + method.name;
        const char *is_default = method.kind != kind ? "  default" : "";
        kind = method.kind;
        list += fmt::format("{:<26}{:<9}  {}\n", choice, is_default, method.source);
    }
    return list;
}

// Stage 07 is about the window, and opens one unless a picture file is asked for.
std::deque<DisplayPath> paths_of(const std::string &stage, const std::string &name,
                                 const Options &options) {
    if (options.window && name == "none") {
        throw UserError("--window and --display none: expected one of them");
    }
    if (name == "none"
        || (name.empty() && !options.window && (stage != "07_interop" || options.out))) {
        return {};
    }
    return name == "copy" ? std::deque{DisplayPath::copy}
                          : std::deque{DisplayPath::shared, DisplayPath::copy};
}

}  // namespace

std::filesystem::path default_out(const std::string &stage) {
    return std::filesystem::path("out") / (stage + ".png");
}

std::optional<Options> parse_options(const std::string &stage, int argc, const char *const *argv) {
    Options options;
    options.scene = std::filesystem::path(STAGELIGHT_SCENES) / (stage + ".toml");
    std::string display;
    std::string texture = "rgba32f";
    std::string size;
    std::vector<std::string> methods;

    CLI::App app("Stagelight " + stage + ": renders a scene with OpenCL", stage);
    app.add_option("scene", options.scene, "a scene in TOML")->capture_default_str();
    const CLI::Option *size_option =
        app.add_option("--size", size, "WIDTHxHEIGHT in pixels (default: the scene's)");
    app.add_option("--out", options.out,
                   "picture to write, .png or .exr (linear float); with a window, its last one "
                   "(default: "
                       + default_out(stage).string() + ", where there is no window)");
    CLI::Option *samples_option =
        app.add_option("--samples", options.samples,
                       "rays through each pixel; in a window they come one by one while nothing "
                       "changes");
    samples_option->check(CLI::Range(1, most_samples))->capture_default_str();
    app.add_option("--depth", options.depth, "bounces (default: the scene's)")
        ->check(CLI::Range(0, most_depth));
    app.add_option(
        "--device", options.device,
        "index, a part of a line of --list-devices, cpu or gpu (default: STAGELIGHT_DEVICE, "
        "else the first that can draw the scene, GPUs first)");
    app.add_option("--frames", options.frames,
                   "render the picture, with all of its samples, this often, for --stats (default: "
                   "once, and in a window whenever something changes)")
        ->check(CLI::Range(1, most_frames));
    app.add_flag("--window", options.window,
                 "open a window: F1 shows its keys (else --display none, but for 07_interop)");
    app.add_option("--display", display,
                   "the display path to try first; one that does not work gives way to the next "
                   "(--window: auto, which is shared)")
        ->check(CLI::IsMember(std::vector<std::string>{"auto", "shared", "copy", "none"}));
    app.add_option("--texture", texture, "what the window's texture holds")
        ->check(CLI::IsMember(std::vector<std::string>{"rgba16f", "rgba32f"}))
        ->capture_default_str();
    app.add_option("--scale", options.scale,
                   "the window's pixels for one of the picture's, each way")
        ->check(within(1.0, most_scale))
        ->capture_default_str();
    if (stage_number(stage) >= gamma_stage) {
        app.add_flag("--split", options.split,
                     "left as it is meant, right without gamma: nothing decoded, nothing encoded");
    }
    app.add_option("--method", methods,
                   "KIND=NAME, one way to do what can be done in several; 'list' lists them")
        ->take_all();
    if (stage_number(stage) >= cutoff_stage) {
        app.add_option(
               "--max-error", options.max_error,
               "choose the fastest methods and depth whose picture is off from the truth by "
               "no more than this (RMSE in linear light); what --method says stays")
            ->check(within(std::numeric_limits<double>::min(), 1e6))
            ->excludes(samples_option);
    }
    app.add_option("--kernels", options.kernels,
                   "read the kernels from DIR, which holds kernels/ and stages/ (default: "
                   "STAGELIGHT_KERNELS, else those in the program)");
    app.add_option("--stats", options.stats, "JSON file to write figures to");
    app.add_option("--export-pov", options.export_pov,
                   "write the scene to FILE, for POV-Ray 3.7, and leave");
    app.add_flag("--list-devices", options.list_devices, "list the OpenCL devices, and leave");
    app.add_flag(
        "--verbose", options.verbose,
        "say more: where the time went, rays that were cut off, what the kernel leaves out");
    app.add_flag("--quiet", options.quiet, "print no warnings; --stats has them all the same");
    app.set_version_flag("--version", "Stagelight " STAGELIGHT_VERSION);

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp &) {
        fmt::print("{}", app.help());
        return std::nullopt;
    } catch (const CLI::CallForVersion &) {
        fmt::print("{}\n", app.version());
        return std::nullopt;
    } catch (const CLI::ParseError &error) {
        throw UserError(fmt::format("{} (--help lists the options)", error.what()));
    }
    require_distinct_files(options);
    options.display = paths_of(stage, display, options);
    options.texture_format = texture == "rgba16f" ? TextureFormat::rgba16f : TextureFormat::rgba32f;
    if (options.split && options.out && is_exr(*options.out)) {
        throw UserError(fmt::format("--split --out {}: expected a .png, the eye's; EXR is linear",
                                    options.out->string()));
    }
    if (size_option->count() > 0) {
        options.size = parse_size(size);
    }
    if (std::ranges::find(methods, "list") != methods.end()) {
        fmt::print("{}", list_methods(stage_number(stage)));
        return std::nullopt;
    }
    for (const std::string &choice : methods) {
        choose_method(options.methods, choice, stage_number(stage));
    }
    return options;
}

}  // namespace stagelight

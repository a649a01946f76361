// SPDX-License-Identifier: MIT
// ./stagelight golden: holds the default device to the golden pictures, or makes them anew.
#include <chrono>
#include <fstream>
#include <span>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/run_main.h"
#include "bench/report.h"
#include "golden/results.h"
#include "golden/spread.h"
#include "golden/suite.h"
#include "scene/errors.h"
#include "scene/progress.h"

namespace stagelight::golden {
namespace {

const std::filesystem::path log_file =
    std::filesystem::path(STAGELIGHT_SOURCE_DIR) / "golden" / "log.md";

constexpr auto usage = "usage: golden [tolerances | update STAGE --reason TEXT]";

bool same(const stagelight::Golden &a, const stagelight::Golden &b) {
    return a.image.width == b.image.width && a.image.height == b.image.height
           && a.image.pixels == b.image.pixels && a.edge == b.edge;
}

// What the new picture is beside the old one, as figures.
std::string difference(const stagelight::Golden &now, const std::filesystem::path &old_file) {
    if (!std::filesystem::exists(old_file)) {
        return "new";
    }
    try {
        const stagelight::Golden old = read_golden(old_file);
        return same(now, old) ? "" : to_string(compare(now.image, old.image, old.edge, {}));
    } catch (const UserError &error) {
        return fmt::format("the old one could not be read: {}", error.what());
    }
}

// Draws the scene and puts its golden in the place of the old one if they differ. Returns what
// has changed, or nothing.
std::string update_scene(const GoldenScene &scene) {
    const reference::Result truth = draw_reference(scene);
    const std::filesystem::path fresh = scene.golden.string() + ".new.exr";
    write_golden({truth.image, truth.edge}, fresh);
    std::string change = difference(read_golden(fresh), scene.golden);
    if (change.empty()) {
        std::filesystem::remove(fresh);
    } else {
        std::filesystem::rename(fresh, scene.golden);
    }
    return change;
}

void update(const std::string &stage, const std::string &reason) {
    const auto now = std::chrono::system_clock::now();
    const std::vector<GoldenScene> scenes = scenes_of(stage);
    Progress progress("drawing with the reference", scenes.size());
    for (const GoldenScene &scene : scenes) {
        const std::string change = update_scene(scene);
        progress.step();
        say(scene.name + ": " + (change.empty() ? "unchanged" : change));
        if (!change.empty()) {
            std::ofstream log(log_file, std::ios::app);
            log << fmt::format("* {:%Y-%m-%d} {}: {} ({})\n", now, scene.name, reason, change);
        }
    }
}

// Every golden beside what the default device draws today, by the suite's own tolerances.
int check() {
    int code = exit_done;
    const std::vector<GoldenScene> scenes = all_scenes();
    Progress progress("drawing on the device", scenes.size());
    for (const GoldenScene &scene : scenes) {
        const Held held = hold_to_golden(scene, "");
        progress.step();
        say(scene.name + ": " + to_string(held.comparison));
        if (!held.failure.empty()) {
            say("  FAILED: " + held.failure);
            code = exit_check_failed;
        }
    }
    return code;
}

// Every bound of the tolerances beside what pictures of devices that are right need of it.
int check_tolerances() {
    Progress progress("drawing on both devices", all_scenes().size());
    int code = exit_done;
    std::vector<std::vector<std::string>> rows{
        {"bound", "allows", "needed", "times", "proposed", "verdict", "by"}};
    for (const Needed &needed : measure_spread([&progress] { progress.step(); })) {
        const char *verdict = needed.needed > needed.bound                            ? "too tight"
                              : is_too_loose(needed.key, needed.bound, needed.needed) ? "too loose"
                                                                                      : "";
        if (*verdict != '\0') {
            code = exit_check_failed;
        }
        rows.push_back(
            {needed.place + '.' + needed.key, fmt::format("{:.3g}", needed.bound),
             fmt::format("{:.3g}", needed.needed),
             needed.needed > 0 ? fmt::format("{:.1f}", needed.bound / needed.needed) : "",
             fmt::format("{:.3g}", proposed_bound(needed.key, needed.needed)), verdict, needed.by});
    }
    say(bench::table(rows));
    return code;
}

int run(std::span<const char *const> arguments) {
    if (arguments.empty()) {
        return check();
    }
    if (arguments.size() == 1 && std::string(arguments[0]) == "tolerances") {
        return check_tolerances();
    }
    const bool complete = arguments.size() == 4 && std::string(arguments[0]) == "update"
                          && std::string(arguments[2]) == "--reason" && *arguments[3] != '\0';
    if (!complete) {
        throw UserError(fmt::format("{}: a golden is not changed without a reason", usage));
    }
    update(arguments[1], one_line(arguments[3]));
    return exit_done;
}

}  // namespace
}  // namespace stagelight::golden

int main(int argc, char **argv) {
    return stagelight::run_main([&] {
        return stagelight::golden::run({argv + 1, static_cast<std::size_t>(argc - 1)});
    });
}

// SPDX-License-Identifier: MIT
// ./stagelight povray: how far POV-Ray's pictures of every stage's scenes are from the reference's,
// as a table of docs/pov-ray.md, in out/povray.json and as pictures in out/povray.
#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "app/run_main.h"
#include "bench/report.h"
#include "image/image_io.h"
#include "povray/judge.h"
#include "scene/errors.h"

namespace stagelight::povray {
namespace {

// Both pictures, and 16 times how far they are apart.
void write_pictures(const Verdict &verdict, const std::filesystem::path &file) {
    constexpr float amplified = 16;
    Image difference = verdict.povray;
    std::ranges::transform(
        verdict.povray.pixels, verdict.truth.image.pixels, difference.pixels.begin(),
        [](const glm::vec3 &a, const glm::vec3 &b) { return amplified * glm::abs(a - b); });
    write_image(verdict.povray, file.string() + ".povray.png", Transfer::srgb);
    write_image(verdict.truth.image, file.string() + ".reference.png", Transfer::srgb);
    write_image(difference, file.string() + ".difference.png", Transfer::none);
}

bench::ordered_json json_of(const JudgedScene &scene, const Comparison &figures) {
    return {{"pixels", scene.width * scene.height},
            {"edge_pixels", figures.edge_pixels},
            {"interior_outliers", figures.interior_outliers},
            {"worst_interior", figures.worst_interior},
            {"edge_outliers", figures.edge_outliers},
            {"strays", figures.strays},
            {"mean_signed_error", figures.mean_signed_error},
            {"rmse", figures.rmse},
            {"failure", figures.failure}};
}

std::string row_of(const std::string &scene, const Comparison &figures) {
    return fmt::format("| {} | {} | {:.2g} | {} | {} | {} | {:.1e} | {:.1e} |\n", scene,
                       figures.interior_outliers, figures.worst_interior, figures.edge_pixels,
                       figures.edge_outliers, figures.strays, figures.mean_signed_error,
                       figures.rmse);
}

int run() {
    const std::filesystem::path report = bench::report_file("povray.json");
    const std::filesystem::path folder = report.parent_path() / "povray";
    std::filesystem::create_directories(folder);
    bench::ordered_json json;
    int code = exit_done;
    fmt::print(
        "| scene | off inside | worst inside | pixels on edges | off there | strays | mean signed "
        "error | RMSE |\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const JudgedScene &scene : judged_scenes()) {
        const Verdict verdict = judge(scene, folder);
        write_pictures(verdict, folder / scene.name);
        json[scene.name] = json_of(scene, verdict.comparison);
        fmt::print("{}", row_of(scene.name, verdict.comparison));
        if (!verdict.comparison.failure.empty()) {
            bench::say(scene.name + ": " + verdict.comparison.failure);
            code = exit_check_failed;
        }
    }
    bench::write_report(json, report);
    return code;
}

}  // namespace
}  // namespace stagelight::povray

int main() {
    return stagelight::run_main(stagelight::povray::run);
}

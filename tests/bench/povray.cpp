// SPDX-License-Identifier: MIT
#include "bench/povray.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "bench/report.h"
#include "scene/errors.h"

namespace stagelight::bench {
namespace {

Image read_exr(const std::filesystem::path &file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        throw MachineError(fmt::format("POV-Ray's picture: {}", OIIO::geterror()));
    }
    Image image(input->spec().width, input->spec().height);
    constexpr int first = 0, after_last = 3;
    if (!input->read_image(0, 0, first, after_last, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
        throw MachineError(fmt::format("POV-Ray's picture: {}", input->geterror()));
    }
    return image;
}

// The milliseconds of a line "NAME Time: 0 hours 0 minutes 1 seconds (1.285 seconds)".
double time_in(const std::string &log, const std::string &name) {
    const std::size_t bracket = log.find('(', log.find(name + " Time: "));
    if (bracket == std::string::npos) {
        throw MachineError(fmt::format("POV-Ray says no {} Time", name));
    }
    return 1000 * std::stod(log.substr(bracket + 1));
}

}  // namespace

PovRayPicture run_povray(const std::filesystem::path &scene, int width, int height, int threads) {
    std::filesystem::path log = scene;
    log.replace_extension("log");
    // Floats, no anti-aliasing, no window.
    const std::string command = fmt::format(
        "cd '{}' && povray '{}' +W{} +H{} +WT{} +FE -A -D >'{}' 2>&1", scene.parent_path().string(),
        scene.filename().string(), width, height, threads, log.filename().string());
    PovRayPicture picture;
    int status = 0;
    picture.wall = time_of([&] { status = std::system(command.c_str()); });
    constexpr int not_found = 127;  // the shell's word
    if (WIFEXITED(status) && WEXITSTATUS(status) == not_found) {
        throw MachineError("there is no povray: apt-get install povray");
    }
    if (status != 0) {
        throw MachineError(fmt::format("POV-Ray fails; {} says why", log.string()));
    }
    std::ifstream stream(log);
    const std::string said(std::istreambuf_iterator<char>(stream), {});
    picture.parsing = time_in(said, "Parse");
    picture.tracing = time_in(said, "Trace");
    picture.image = read_exr(std::filesystem::path(scene).replace_extension("exr"));
    return picture;
}

}  // namespace stagelight::bench

// SPDX-License-Identifier: MIT
#include "device/renderer.h"

#include <algorithm>
#include <vector>

#include <glm/vec4.hpp>

#include "device/device_types.h"
#include "device/memory_need.h"
#include "scene/clock.h"
#include "scene/progress.h"

namespace stagelight {

Renderer::Renderer(const cl::Device &device, const std::string &stage, const Scene &scene,
                   const RenderSettings &settings)
    : device_(device), settings_(settings), context_(device), queue_(context_, device),
      kernel_(context_, device, stage, scene, settings),
      image_(context_, CL_MEM_WRITE_ONLY, picture_bytes(device, settings.width, settings.height)),
      camera_(to_device(scene.camera, settings.width, settings.height)) {
    camera_.media = kernel_.media().at(scene, scene.camera.position);
}

std::map<std::string, std::size_t> Renderer::bytes() const {
    std::map<std::string, std::size_t> bytes = kernel_.bytes();
    bytes["image"] = image_.getInfo<CL_MEM_SIZE>();
    return bytes;
}

double Renderer::launch(int sample) {
    kernel_.clear_ray_counts(queue_, settings_.height);
    queue_.finish();
    const double start = now_milliseconds();
    kernel_.launch(queue_, image_, camera_, sample);
    queue_.finish();
    return now_milliseconds() - start;
}

Frame Renderer::render() {
    Frame frame;
    frame.image = Image(settings_.width, settings_.height);
    std::vector<glm::vec4> pixels(frame.image.pixels.size());
    std::vector<device::RayCounts> rows;
    Progress progress("rendering samples", static_cast<std::size_t>(settings_.samples));
    for (int i = 0; i < settings_.samples; ++i) {
        frame.milliseconds += launch(i);
        kernel_.read_ray_counts(queue_, rows);
        queue_.finish();
        frame.rays += totals_of(rows, pixels.size());
        progress.step();
    }
    queue_.enqueueReadBuffer(image_, CL_TRUE, 0, pixels.size() * sizeof pixels[0], pixels.data());
    std::ranges::transform(pixels, frame.image.pixels.begin(),
                           [](const glm::vec4 &pixel) { return glm::vec3(pixel); });
    return frame;
}

}  // namespace stagelight

// SPDX-License-Identifier: MIT
// One stage's kernel, built for one scene and ready to launch.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "device/media.h"
#include "device/methods.h"
#include "device/opencl.h"
#include "device/ray_totals.h"
#include "device/sample_mean.h"
#include "device/scene_needs.h"
#include "scene/scene.h"
#include "scene_types.h"

namespace stagelight {

struct RenderSettings {
    int width = 640;
    int height = 384;
    int max_depth = 8;
    int samples = 1;  // a pixel
    Methods methods;
    std::optional<std::filesystem::path> kernels;  // a checkout to read the kernels from
    bool eye_moves = false;                        // into glass, perhaps
    bool split = false;  // right of the middle, texels are taken for light (stage 08)
};

// What the kernel writes to (kernels/picture.cl): a buffer of float4, or an image.
enum class Picture { buffer, image };

// What making a StageKernel has taken, milliseconds.
struct BuildTimes {
    double tree = 0;    // of boxes over the triangles
    double kernel = 0;  // the driver's compiler, or its cache
    double upload = 0;  // scene and textures, converted and copied
};

// Warns where the chosen width is one that a device of this kind is slow with.
void warn_of_width(const cl::Device &device, const Methods &methods);

class StageKernel {
public:
    // `stage` is its folder's name, "04_refraction_beer". Throws as require_memory, build_program
    // and DeviceScene do.
    StageKernel(const cl::Context &context, const cl::Device &device, const std::string &stage,
                const Scene &scene, const RenderSettings &settings,
                Picture picture = Picture::buffer);

    // Makes ready for a picture of `height` rows, and counts rays from 0. In-order, as all here.
    void clear_ray_counts(const cl::CommandQueue &queue, int height);
    // The sample `sample` of each pixel of `camera`'s picture: the mean of it and of those before
    // it, 0 first, goes into `image`, which is what `picture` said.
    void launch(const cl::CommandQueue &queue, const cl::Memory &image,
                const device::DoubleCamera &camera, int sample = 0);
    // Without waiting: `rows` is filled when the queue has come that far.
    void read_ray_counts(const cl::CommandQueue &queue, std::vector<device::RayCounts> &rows) const;

    const cl::Kernel &kernel() const { return kernel_; }
    const SceneNeeds &needs() const { return needs_; }
    const Media &media() const { return media_; }
    const std::string &options() const { return options_; }
    const BuildTimes &milliseconds() const { return milliseconds_; }
    // What lies on the device, by argument; the picture is not the kernel's.
    std::map<std::string, std::size_t> bytes() const;

private:
    void learn_arguments();
    void make_room_for_ray_counts(int height);
    void render(const cl::CommandQueue &queue, const cl::Memory &image,
                const device::DoubleCamera &camera);
    void launch_split(const cl::CommandQueue &queue, int width, int height);

    cl::Context context_;
    SceneNeeds needs_;
    Media media_;
    std::string options_;
    cl::Kernel kernel_;
    std::optional<DeviceScene> scene_;
    std::vector<std::string> names_;  // of the kernel's arguments, in order
    std::map<std::string, cl_uint> arguments_;
    std::optional<TextureArray> plain_textures_;  // not decoded, for the right half of a split
    std::optional<cl::Buffer> ray_counts_;
    int width_ = 1;  // pixels of a work-item
    // Work-items of a group: few where each draws many pixels, so that no core runs out early.
    std::size_t group_width_ = 1;
    std::size_t group_height_ = 1;
    int samples_;
    bool is_double_;
    std::optional<SampleMean> mean_;  // of more than one sample
    BuildTimes milliseconds_;
};

}  // namespace stagelight

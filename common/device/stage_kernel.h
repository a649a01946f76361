// SPDX-License-Identifier: MIT
// One stage's kernel, built for one scene and ready to launch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "device/media.h"
#include "device/methods.h"
#include "device/opencl.h"
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

// Summed over all samples of a picture.
struct RayTotals {
    std::uint64_t primary = 0;
    std::uint64_t shadow = 0;
    std::uint64_t reflection = 0;
    std::uint64_t refraction = 0;
    std::uint64_t dropped = 0;  // cut off by the depth limit
    std::uint64_t cut_off = 0;  // too weak to be traced
    double cut_off_weight = 0;  // the largest sum of their weights in one sample of a pixel

    RayTotals &operator+=(const RayTotals &more);
    std::uint64_t traced() const { return primary + shadow + reflection + refraction; }
    // Million rays a second, of a picture that took so long.
    double rate(double milliseconds) const {
        return static_cast<double>(traced()) / milliseconds / 1000;
    }
};

// What making a StageKernel has taken, milliseconds.
struct BuildTimes {
    double tree = 0;    // of boxes over the triangles
    double kernel = 0;  // the driver's compiler, or its cache
    double upload = 0;  // scene and textures, converted and copied
};

// -cl-std and the names that kernels/ are built with for a scene, its methods and what the device
// has. Throws DeviceError for a method that the device lacks.
std::string build_options(const cl::Device &device, const SceneNeeds &needs,
                          const Methods &methods);

// Warns where the chosen width is one that a device of this kind is slow with.
void warn_of_width(const cl::Device &device, const Methods &methods);

// Builds `source`. Where it does not build, throws the log: as a KernelError if it was read
// `from_disk` (the user's own work), else as a DeviceError.
cl::Program build_program(const cl::Context &context, const std::string &source,
                          const std::string &options, bool from_disk = false);

// The point of a pixel, in [0, 1), that the sample `index` of `count` goes through.
device::double2 sample_point(int index, int count);

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

// The rows' sum, and a primary ray for each of `pixels`.
RayTotals totals_of(const std::vector<device::RayCounts> &rows, std::size_t pixels);

}  // namespace stagelight

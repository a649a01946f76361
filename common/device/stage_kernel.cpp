// SPDX-License-Identifier: MIT
#include "device/stage_kernel.h"

#include <algorithm>

#include <fmt/format.h>

#include "device/device_choice.h"
#include "device/device_types.h"
#include "device/driver_watch.h"
#include "device/kernel_source.h"
#include "device/memory_need.h"
#include "device/program.h"
#include "image/split.h"
#include "scene/clock.h"
#include "scene/errors.h"
#include "scene/progress.h"
#include "scene/stages.h"

namespace stagelight {
namespace {

// To cover `pixels` by blocks, in whole groups.
std::size_t work_items(int pixels, int block, std::size_t group) {
    const auto items = static_cast<std::size_t>((pixels + block - 1) / block);
    return (items + group - 1) / group * group;
}

// How many rays one work-item traces side by side (kernels/packets/wide.cl).
int rays_at_a_time(const cl::Device &device, const RenderSettings &settings) {
    const std::string chosen = choice(settings.methods, "width");
    if (settings.split) {
        return 1;  // its line may run through a tile
    }
    if (chosen != "device") {
        return std::stoi(chosen);
    }
    const cl_uint preferred = is_double(settings.methods)
                                  ? device.getInfo<CL_DEVICE_PREFERRED_VECTOR_WIDTH_DOUBLE>()
                                  : device.getInfo<CL_DEVICE_PREFERRED_VECTOR_WIDTH_FLOAT>();
    return is_gpu(device) || preferred < 4 ? 1 : preferred < 8 ? 4 : preferred < 16 ? 8 : 16;
}

// Milliseconds of an action, which a terminal is told of where they are many.
double timed(const char *what, const auto &action) {
    const Progress progress(what);
    const double start = now_milliseconds();
    action();
    return now_milliseconds() - start;
}

cl::Kernel render_kernel(const cl::Program &program, bool from_disk) {
    try {
        return {program, "render"};
    } catch (const cl::Error &error) {
        if (error.err() == CL_INVALID_KERNEL_NAME && from_disk) {
            throw KernelError("there is no kernel 'render' in the stage's kernel.cl");
        }
        if (error.err() == CL_INVALID_KERNEL_NAME) {
            start_again_if_watched();
            throw DeviceError("the driver finds no kernel 'render' in what it has compiled; try "
                              "another POCL_CACHE_DIR, or another --device (--list-devices)");
        }
        throw;
    }
}

// As near a square as the device takes, at most `wanted` work-items each way.
std::pair<std::size_t, std::size_t> group_of(const cl::Device &device, const cl::Kernel &kernel,
                                             std::size_t wanted) {
    const std::size_t most = kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device);
    const std::vector<std::size_t> sides = device.getInfo<CL_DEVICE_MAX_WORK_ITEM_SIZES>();
    std::size_t width = std::min(wanted, sides.at(0));
    std::size_t height = std::min(wanted, sides.at(1));
    while (width * height > most) {
        std::size_t &longer = height >= width ? height : width;
        longer /= 2;
    }
    return {width, height};
}

}  // namespace

void warn_of_width(const cl::Device &device, const Methods &methods) {
    const std::string width = choice(methods, "width");
    if (is_gpu(device) && width != "device" && width != "1") {
        warn(fmt::format("--method width={}: {} is a GPU, whose work-items are as many rays side "
                         "by side already; width=1 is faster there",
                         width, device.getInfo<CL_DEVICE_NAME>()));
    }
}

StageKernel::StageKernel(const cl::Context &context, const cl::Device &device,
                         const std::string &stage, const Scene &scene,
                         const RenderSettings &settings, Picture picture)
    : context_(context),
      needs_(needs_of(scene, stage_number(stage), settings.max_depth, cutoff_of(settings.methods),
                      has_smooth_shadows(settings.methods))),
      media_(scene, settings.eye_moves), samples_(settings.samples),
      is_double_(is_double(settings.methods)) {
    const int number = stage_number(stage);
    const Transfer decode = decode_of(number, settings.methods);
    require_memory(device, scene, decode, picture_bytes(device, settings.width, settings.height),
                   settings.samples > 1 ? 3 : 1);  // a sample and the sum of all, beside their mean
    if (number >= packet_stage) {
        width_ = rays_at_a_time(device, settings);
        needs_.emplace_back("WIDTH", width_);
    }
    if (number > 1 && !media_.materials().empty()) {
        needs_.emplace_back("HAS_MEDIA", 1);
    }
    Bvh bvh;
    if (number >= tree_stage) {
        const bool padded = choice(settings.methods, "box") == "robust";
        milliseconds_.tree = timed("building the tree", [&] { bvh = build_bvh(scene, padded); });
    }
    if (!bvh.nodes.empty()) {
        constexpr int step = 16;  // so that trees of much the same depth share a program
        needs_.emplace_back("HAS_TREE", 1);
        needs_.emplace_back("BVH_STACK_SIZE", (bvh.stack_size + step - 1) / step * step);
    }
    const std::string writes = picture == Picture::image ? " -D PICTURE_IS_IMAGE=1" : "";
    options_ = build_options(device, needs_, settings.methods) + (samples_ > 1 ? "" : writes);
    // Where a work-item has one ray, packets give way to the tree for one.
    const std::string &lesson =
        number >= packet_stage && width_ == 1 ? stage_name(tree_stage) : stage;
    const std::string source =
        kernel_source("stages/" + lesson + "/kernel.cl", settings.kernels,
                      files_of(with_defaults(settings.methods, number), needs_));
    milliseconds_.kernel = timed("building the kernel", [&] {
        const bool from_disk = named_kernels(settings.kernels).has_value();
        kernel_ = render_kernel(build_program(context, source, options_, from_disk), from_disk);
        if (samples_ > 1) {
            mean_.emplace(context, language_of(device) + writes, settings.kernels);
        }
    });
    milliseconds_.upload = timed("copying the scene to the device", [&] {
        names_ = argument_names(kernel_, argument_order(needs_, number));
        scene_.emplace(context, device, kernel_, names_, scene, decode, bvh, media_);
        if (settings.split && scene_->textures()) {
            plain_textures_.emplace(context, device, scene, Transfer::none);
        }
    });
    const auto [width, height] = group_of(device, kernel_, width_ == 1 ? 8 : 2);
    group_width_ = width;
    group_height_ = height;
    learn_arguments();
    make_room_for_ray_counts(settings.height);
}

// A kernel of the user's own may lack one, or have one that nobody fills.
void StageKernel::learn_arguments() {
    for (cl_uint i = 0; i < names_.size(); ++i) {
        arguments_[names_[i]] = i;
    }
    for (const char *name : {"image", "camera"}) {
        if (!arguments_.contains(name)) {
            throw KernelError(fmt::format("the kernel 'render' has no argument '{}'", name));
        }
    }
    for (const std::string &name : names_) {
        const bool ours = name == "image" || name == "camera" || name == "ray_counts";
        if (!ours && !scene_->has_set(name)) {
            throw KernelError(fmt::format(
                "the kernel 'render' has an argument '{}', which this scene does not fill", name));
        }
    }
}

std::map<std::string, std::size_t> StageKernel::bytes() const {
    std::map<std::string, std::size_t> bytes = scene_->bytes();
    if (plain_textures_) {
        bytes["plain_textures"] = plain_textures_->bytes();
    }
    if (ray_counts_) {
        bytes["ray_counts"] = ray_counts_->getInfo<CL_MEM_SIZE>();
    }
    if (mean_) {
        bytes.merge(mean_->bytes());
    }
    return bytes;
}

void StageKernel::make_room_for_ray_counts(int height) {
    const std::size_t size = static_cast<std::size_t>(height) * sizeof(device::RayCounts);
    if (arguments_.contains("ray_counts")
        && (!ray_counts_ || ray_counts_->getInfo<CL_MEM_SIZE>() != size)) {
        ray_counts_ = cl::Buffer(context_, CL_MEM_READ_WRITE, size);
        kernel_.setArg(arguments_.at("ray_counts"), *ray_counts_);
    }
}

void StageKernel::clear_ray_counts(const cl::CommandQueue &queue, int height) {
    make_room_for_ray_counts(height);
    if (ray_counts_) {
        queue.enqueueFillBuffer(*ray_counts_, cl_uint{0}, 0, ray_counts_->getInfo<CL_MEM_SIZE>());
    }
}

void StageKernel::launch(const cl::CommandQueue &queue, const cl::Memory &image,
                         const device::DoubleCamera &camera, int sample) {
    device::DoubleCamera through = camera;
    through.sample = sample_point(sample, samples_);
    render(queue, mean_ ? mean_->sample(camera.size) : image, through);
    if (mean_) {
        mean_->add(queue, image, sample);
    }
}

void StageKernel::render(const cl::CommandQueue &queue, const cl::Memory &image,
                         const device::DoubleCamera &camera) {
    kernel_.setArg(arguments_.at("image"), image);
    if (is_double_) {
        kernel_.setArg(arguments_.at("camera"), camera);
    } else {
        kernel_.setArg(arguments_.at("camera"), to_single(camera));
    }
    const auto [width, height] = camera.size.s;
    if (plain_textures_) {
        launch_split(queue, width, height);
    } else {
        // #region launch
        const bool packets = width_ > 1;
        const int tile_width = packets ? TILE_WIDTH_OF(width_) : 1;
        const int tile_height = width_ / tile_width;
        const int tiles = packets ? PACKETS_IN_ROW : 1;  // and as many below each other
        queue.enqueueNDRangeKernel(
            kernel_, cl::NullRange,
            cl::NDRange(work_items(width, tiles * tile_width, group_width_),
                        work_items(height, tiles * tile_height, group_height_)),
            cl::NDRange(group_width_, group_height_));
        // #endregion launch
    }
}

// The halves have no width that a work-group of ours divides: the driver chooses one.
void StageKernel::launch_split(const cl::CommandQueue &queue, int width, int height) {
    const auto launch_columns = [&](const TextureArray &textures, int first, int end) {
        if (first < end) {
            kernel_.setArg(arguments_.at("textures"), textures.image());
            queue.enqueueNDRangeKernel(kernel_, cl::NDRange(std::size_t(first), 0),
                                       cl::NDRange(std::size_t(end - first), std::size_t(height)));
        }
    };
    const int middle = split_line(split_share, width).begin;
    launch_columns(*scene_->textures(), 0, middle);
    launch_columns(*plain_textures_, middle, width);
}

void StageKernel::read_ray_counts(const cl::CommandQueue &queue,
                                  std::vector<device::RayCounts> &rows) const {
    rows.clear();
    if (ray_counts_) {
        rows.resize(ray_counts_->getInfo<CL_MEM_SIZE>() / sizeof(device::RayCounts));
        queue.enqueueReadBuffer(*ray_counts_, CL_FALSE, 0, rows.size() * sizeof rows[0],
                                rows.data());
    }
}

}  // namespace stagelight

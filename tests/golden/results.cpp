// SPDX-License-Identifier: MIT
#include "golden/results.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "app/stats.h"
#include "device/device_choice.h"
#include "image/image_io.h"
#include "image/outliers.h"
#include "image/whole_file.h"
#include "implementations.h"
#include "scene/errors.h"

namespace stagelight::golden {
namespace {

using nlohmann::ordered_json;
using Path = std::filesystem::path;

// What lies side by side on the page.
struct Pair {
    const Image &picture;
    const stagelight::Golden &golden;
    double tolerance;

    Outlier outlier(int x, int y) const {
        return outlier_at(picture, golden.image, golden.edge, tolerance, x, y);
    }
    double error(int x, int y) const { return error_of(picture.at(x, y), golden.image.at(x, y)); }
};

Image map_pixels(const Image &size, const auto &value) {
    Image made(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            made.at(x, y) = value(x, y);
        }
    }
    return made;
}

Image difference_of(const Pair &pair) {
    return map_pixels(pair.picture, [&](int x, int y) {
        return 16.0F * glm::abs(pair.picture.at(x, y) - pair.golden.image.at(x, y));
    });
}

Image mask_of(const stagelight::Golden &golden) {
    return map_pixels(golden.image, [&](int x, int y) {
        return glm::vec3(golden.edge[std::size_t(y * golden.image.width + x)]);
    });
}

// Over the mask in grey: colours that are told apart by those who see no red or green too.
Image outlier_map(const Pair &pair) {
    const Image mask = mask_of(pair.golden);
    return map_pixels(pair.picture, [&](int x, int y) {
        switch (pair.outlier(x, y)) {
        case Outlier::interior:
            return glm::vec3(1, 0.35F, 0);
        case Outlier::edge:
            return glm::vec3(0.35F, 0.7F, 1);
        case Outlier::stray:
            return glm::vec3(1, 1, 0.4F);
        case Outlier::none:
            break;
        }
        return 0.25F * mask.at(x, y);
    });
}

std::array<float, 3> color(const glm::vec3 &value) {
    return {value.r, value.g, value.b};
}

ordered_json worst_pixels(const Pair &pair) {
    constexpr std::size_t shown = 8;
    std::vector<glm::ivec2> places;
    for (int y = 0; y < pair.picture.height; ++y) {
        for (int x = 0; x < pair.picture.width; ++x) {
            places.emplace_back(x, y);
        }
    }
    const auto last = places.begin() + std::ptrdiff_t(std::min(shown, places.size()));
    std::partial_sort(places.begin(), last, places.end(), [&](glm::ivec2 a, glm::ivec2 b) {
        return pair.error(a.x, a.y) > pair.error(b.x, b.y);
    });
    const std::map<Outlier, const char *> names{{Outlier::none, "within tolerance"},
                                                {Outlier::interior, "interior outlier"},
                                                {Outlier::edge, "edge outlier"},
                                                {Outlier::stray, "stray"}};
    ordered_json worst = ordered_json::array();
    for (auto place = places.begin(); place != last; ++place) {
        const auto [x, y] = std::pair(place->x, place->y);
        worst.push_back({{"x", x},
                         {"y", y},
                         {"error", pair.error(x, y)},
                         {"kind", names.at(pair.outlier(x, y))},
                         {"golden", color(pair.golden.image.at(x, y))},
                         {"render", color(pair.picture.at(x, y))}});
    }
    return worst;
}

// Pixels by their error, two bins a decade: the first is below 1e-7, the last from 1 on.
std::vector<int> histogram(const Pair &pair) {
    constexpr int bins = 16;
    std::vector<int> counts(bins, 0);
    for (int y = 0; y < pair.picture.height; ++y) {
        for (int x = 0; x < pair.picture.width; ++x) {
            const double bin = std::floor(2 * (std::log10(pair.error(x, y)) + 7)) + 1;
            ++counts[std::size_t(std::clamp(bin, 0.0, double(bins - 1)))];
        }
    }
    return counts;
}

// Where the results of one check go; nowhere when nobody asks for them.
class Results {
public:
    Results(const GoldenScene &scene, const std::string &device, const cl::Device &chosen)
        : name_(fmt::format("{}_on_{}", scene.name, name_in_tests(device_name(chosen)))),
          transfer_(shown_by(scene.stage) == reference::Shown::light ? Transfer::srgb
                                                                     : Transfer::none) {
        const char *folder = std::getenv("STAGELIGHT_RESULTS");
        if (folder == nullptr || *folder == '\0') {
            return;
        }
        folder_ = folder;
        std::error_code ignored;  // what is wrong with the folder is told when it is written to
        std::filesystem::create_directories(*folder_, ignored);
        json_ = {{"scene", scene.name},
                 {"stage", scene.stage},
                 {"device", device_json(chosen)},
                 {"when", fmt::format("{:%Y-%m-%d %H:%M:%S} UTC",
                                      fmt::gmtime(std::chrono::system_clock::now()))},
                 {"tolerance", as_json(tolerance_of(scene.name, device))},
                 {"failure", "the check did not come to its end"}};
        write();
    }

    void leave(const Held &held, const Frame &frame,
               const std::optional<stagelight::Golden> &golden, double tolerance) {
        if (!folder_) {
            return;
        }
        json_["failure"] = held.failure;
        json_["milliseconds"] = frame.milliseconds;
        picture("render", frame.image, transfer_);
        if (golden) {
            picture("golden", golden->image, transfer_);
            picture("edges", mask_of(*golden), Transfer::none);
        }
        if (!std::isnan(held.comparison.rmse)) {
            const Pair pair{frame.image, *golden, tolerance};
            picture("difference", difference_of(pair), Transfer::none);
            picture("outliers", outlier_map(pair), Transfer::none);
            json_["figures"] = as_json(held.comparison);
            json_["worst"] = worst_pixels(pair);
            json_["histogram"] = histogram(pair);
        }
        write();
    }

private:
    static std::string device_name(const cl::Device &device) {
        return device.getInfo<CL_DEVICE_NAME>();
    }
    static ordered_json as_json(const Tolerance &tolerance) {
        return {{"interior", tolerance.interior},
                {"edge_outliers", tolerance.edge_outliers},
                {"strays", tolerance.strays},
                {"mean_signed_error", tolerance.mean_signed_error}};
    }
    static ordered_json as_json(const Comparison &figures) {
        return {{"interior_outliers", figures.interior_outliers},
                {"interior", figures.worst_interior},
                {"edge_outliers", figures.edge_outliers},
                {"strays", figures.strays},
                {"edge_pixels", figures.edge_pixels},
                {"mean_signed_error", figures.mean_signed_error},
                {"rmse", figures.rmse},
                {"psnr", figures.psnr},  // null where it is infinite
                {"perceptual_failures", figures.perceptual_failures}};
    }
    void picture(const std::string &what, const Image &image, Transfer transfer) {
        const std::string file = fmt::format("{}.{}.png", name_, what);
        write_image(image, *folder_ / file, transfer);
        json_["pictures"][what] = file;
    }
    void write() const {
        const std::string text = json_.dump(1, ' ', false, ordered_json::error_handler_t::replace);
        write_whole(std::vector<unsigned char>(text.begin(), text.end()),
                    *folder_ / (name_ + ".json"));
    }

    std::string name_;
    Transfer transfer_;
    std::optional<Path> folder_;
    ordered_json json_;
};

}  // namespace

Held hold_to_golden(const GoldenScene &scene, const std::string &device) {
    Results results(scene, device, choose_device(device));
    const Tolerance tolerance = tolerance_of(scene.name, device);
    const Frame frame = draw_on(scene, device).frame;
    std::optional<stagelight::Golden> golden;
    Held held;
    try {
        golden = read_golden(scene.golden);
        held.comparison = compare(frame.image, golden->image, golden->edge, tolerance);
        held.failure = held.comparison.failure;
    } catch (const UserError &error) {
        held.failure = error.what();
    }
    results.leave(held, frame, golden, tolerance.interior);
    held.picture = frame.image;
    held.golden = golden ? golden->image : Image();
    return held;
}

}  // namespace stagelight::golden

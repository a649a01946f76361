// SPDX-License-Identifier: MIT
#include "chart/scene_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "bench/stages.h"
#include "budget/budget.h"
#include "budget/truth.h"
#include "device/renderer.h"
#include "image/image_io.h"
#include "scene/clock.h"
#include "scene/errors.h"
#include "scene/scene_file.h"
#include "scene/stages.h"

namespace stagelight::chart {
namespace {

// That of the stage which has all methods.
const std::string &stage() {
    static const std::string highest = bench::full_tracer();
    return highest;
}

RenderSettings settings_for(const Scene &scene, int width) {
    RenderSettings settings = bench::settings_of(stage(), scene);
    settings.height = std::max(1, settings.height * width / settings.width);
    settings.width = width;
    return settings;
}

Image difference_of(const Image &picture, const Image &truth) {
    Image difference(picture.width, picture.height);
    std::ranges::transform(
        picture.pixels, truth.pixels, difference.pixels.begin(),
        [](const glm::vec3 &a, const glm::vec3 &b) { return glm::vec3(16) * glm::abs(a - b); });
    return difference;
}

// What the picture is held to: each pixel the mean of 4x4 points of it.
Image supersampled(const Scene &scene, RenderSettings settings) {
    constexpr int points = 4;
    Image mean(settings.width, settings.height);
    settings.width *= points;
    settings.height *= points;
    const Image fine = bench::reference_of(stage(), scene, settings).image;
    for (int y = 0; y < fine.height; ++y) {
        for (int x = 0; x < fine.width; ++x) {
            mean.at(x / points, y / points) += fine.at(x, y) / float(points * points);
        }
    }
    return mean;
}

class Charting {
public:
    Charting(const cl::Device &device, const std::filesystem::path &file,
             const ChartSettings &settings)
        : device_(device), settings_(settings), scene_(load_scene(file)),
          defaults_(settings_for(scene_, settings.width)),
          truth_(bench::reference_of(stage(), scene_, defaults_)),
          renderer_(device, stage(), scene_, defaults_) {
        chart_.name = file.stem();
        chart_.width = defaults_.width;
        chart_.height = defaults_.height;
        default_picture_ = renderer_.render().image;
        constexpr double a_second = 1000;
        rounds_ = std::clamp(static_cast<int>(a_second / renderer_.render().milliseconds), 3,
                             settings.rounds);
        std::filesystem::create_directories(settings_.folder / chart_.name);
    }

    SceneChart chart() {
        add_methods();
        add_encodings();
        if (settings_.with_samples) {
            add_samples();
        }
        find_fronts(chart_.points);
        if (settings_.with_budgets) {
            add_budgets();
        }
        std::vector<double> times;
        for (int i = 0; i < rounds_; ++i) {
            times.push_back(renderer_.render().milliseconds);
        }
        chart_.milliseconds = median(times);
        return std::move(chart_);
    }

private:
    // A kernel that many lanes wide takes minutes to build where the device would have one.
    bool is_left_out(const Method &method) {
        if (method.kind == "encode" || method.name == "device") {
            return true;  // drawn by the host; said by its number
        }
        const std::string options = renderer_.stage_kernel().options() + ' ';
        const bool scalar = options.find("-D WIDTH=1 ") != std::string::npos;
        const bool wide = (method.kind == "width" && method.name != "1") || method.kind == "walk";
        if (scalar && wide) {
            chart_.left_out.push_back(
                {method.kind + '=' + method.name, "the device itself is one lane wide"});
            return true;
        }
        return false;
    }

    bool is_default(const Method &method) {
        if (method.kind != "width") {
            return method.name == choice({}, method.kind, stage_number(stage()));
        }
        return method.name == std::to_string(value_of(renderer_.stage_kernel().needs(), "WIDTH"));
    }

    void add_methods() {
        const int number = stage_number(stage());
        const SceneNeeds needs = needs_of(scene_, number, defaults_.max_depth);
        const Progress progress(chart_.name);
        for (const Method &method : methods_of(number)) {
            if (!matters(method.kind, needs) || is_left_out(method)) {
                continue;
            }
            if (is_default(method)) {
                add(method, default_picture_, 1, true);
                continue;
            }
            RenderSettings with = defaults_;
            with.methods[method.kind] = method.name;
            try {
                Renderer renderer(device_, stage(), scene_, with);
                const Image picture = renderer.render().image;
                if (!std::isfinite(rmse_of(picture, truth_.image))) {  // math=relaxed on LLVM 21
                    chart_.left_out.push_back(
                        {method.kind + '=' + method.name, "it draws what is no number"});
                    continue;
                }
                const double ratio = time_ratio(renderer, renderer_, rounds_);
                add(method, picture, ratio, false);
                if (is_approximate(method.kind)) {
                    measured_.push_back({{method.kind, method.name, ratio}, picture});
                }
            } catch (const MachineError &error) {
                chart_.left_out.push_back({method.kind + '=' + method.name, error.what()});
            }
        }
    }

    // Held to what the defaults approximate, so that no other choice's error hides its own; but by
    // Fresnel's equations where Schlick's approximation is what is asked about.
    const reference::Result &truth_for(const std::string &kind) {
        if (kind != "fresnel") {
            return truth_;
        }
        if (!exact_) {
            exact_ = truth_of(stage(), scene_, defaults_);
        }
        return *exact_;
    }

    void add(const Method &method, const Image &picture, double ratio, bool is_default) {
        const reference::Result &truth = truth_for(method.kind);
        const Comparison comparison = compare(picture, truth.image, truth.edge, Tolerance());
        add({.kind = method.kind,
             .name = method.name,
             .is_default = is_default,
             .ratio = ratio,
             .rmse = rmse_of(picture, truth.image),
             .worst_interior = comparison.worst_interior,
             .perceptual_failures = comparison.perceptual_failures,
             .picture = {},
             .difference = {}},
            picture, truth.image);
    }

    void add(Point point, const Image &picture, const Image &truth) {
        const std::string name = chart_.name + '/' + point.kind + '=' + point.name;
        point.picture = name + ".png";
        point.difference = name + ".difference.png";
        write_image(picture, settings_.folder / point.picture, Transfer::srgb);
        write_image(difference_of(picture, truth), settings_.folder / point.difference,
                    Transfer::none);
        chart_.points.push_back(std::move(point));
    }

    // On the host: how long it takes to make the 8 bits of a picture, and how far they are, taken
    // for sRGB, from the light that they stand for.
    void add_encodings() {
        double of_default = 0;
        for (const Method &method : methods_of(stage_number(stage()))) {
            if (method.kind != "encode") {
                continue;
            }
            const Transfer curve = encode_of(stage_number(stage()), {{"encode", method.name}});
            Image shown(truth_.image.width, truth_.image.height);
            Image shown_truth = shown;
            std::vector<double> times;
            for (int i = 0; i < rounds_; ++i) {
                const double start = now_milliseconds();
                std::ranges::transform(
                    truth_.image.pixels, shown.pixels.begin(), [curve](const glm::vec3 &light) {
                        return glm::vec3(encode(curve, light.x), encode(curve, light.y),
                                         encode(curve, light.z));
                    });
                times.push_back(now_milliseconds() - start);
            }
            const auto light_of_code = [](float value) {
                return decode(Transfer::srgb, std::round(255 * value) / 255);
            };
            for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
                for (int channel = 0; channel < 3; ++channel) {
                    float &value = shown.pixels[i][channel];
                    value = light_of_code(value);
                    shown_truth.pixels[i][channel] =
                        std::clamp(truth_.image.pixels[i][channel], 0.0F, 1.0F);
                }
            }
            const bool is_default = method.name == choice({}, "encode");
            of_default = is_default ? median(times) : of_default;
            const Comparison comparison = compare(shown, shown_truth, truth_.edge, Tolerance());
            add({.kind = method.kind,
                 .name = method.name,
                 .is_default = is_default,
                 .ratio = median(times) / of_default,
                 .rmse = comparison.rmse,
                 .worst_interior = comparison.worst_interior,
                 .perceptual_failures = comparison.perceptual_failures,
                 .picture = {},
                 .difference = {}},
                shown, shown_truth);
        }
    }

    void add_samples() {
        const Image truth = supersampled(scene_, defaults_);
        for (const int samples : {1, 4, 16}) {
            RenderSettings with = defaults_;
            with.samples = samples;
            Renderer renderer(device_, stage(), scene_, with);
            const Image picture = renderer.render().image;
            const Comparison comparison = compare(picture, truth, truth_.edge, Tolerance());
            add({.kind = "samples",
                 .name = std::to_string(samples),
                 .is_default = samples == 1,
                 .ratio = time_ratio(renderer, renderer_, rounds_),
                 .rmse = comparison.rmse,
                 .worst_interior = comparison.worst_interior,
                 .perceptual_failures = comparison.perceptual_failures,
                 .picture = {},
                 .difference = {}},
                picture, truth);
        }
    }

    // As probe_methods has them, from what was drawn already; but with Fresnel's equations in the
    // place of Schlick's, since they are the truth.
    Probes probes() {
        const auto exact = std::ranges::find_if(measured_, [](const Measured &measured) {
            return measured.probe.kind == "fresnel" && measured.probe.name == "exact";
        });
        Probes probes;
        const bool has_glass = exact != measured_.end();
        const Image &base = has_glass ? exact->picture : default_picture_;
        if (has_glass) {
            probes.base = {{"fresnel", "exact"}};
            probes.probes.push_back(
                {"fresnel", "schlick", 1 / exact->probe.ratio, rmse_of(default_picture_, base)});
        }
        probes.base_error = rmse_of(base, truth_for("fresnel").image);
        for (const Measured &measured : measured_) {
            Probe probe = measured.probe;
            if (probe.name == "fp64") {
                probe.error = rmse_of(measured.picture, truth_.image);
                probes.in_double = probe;
                continue;
            }
            const bool of_glass = probe.kind == "fresnel";
            if (of_glass && probe.name == "exact") {
                continue;
            }
            probe.error = rmse_of(measured.picture, of_glass ? base : default_picture_);
            probe.ratio /= of_glass ? exact->probe.ratio : 1;
            probes.probes.push_back(probe);
        }
        return probes;
    }

    void measure_limits() {
        const SceneNeeds needs = needs_of(scene_, stage_number(stage()), defaults_.max_depth);
        if (!matters("depth", needs)) {
            return;
        }
        for (const int limit : limits_below(defaults_.max_depth)) {
            RenderSettings with = defaults_;
            with.max_depth = limit;
            Renderer renderer(device_, stage(), scene_, with);
            const Image picture = renderer.render().image;
            measured_.push_back(
                {{"limit", std::to_string(limit), time_ratio(renderer, renderer_, rounds_)},
                 picture});
        }
    }

    void add_budgets() {
        measure_limits();
        const Probes known = probes();
        for (const double max_error : {1e-2, 1e-3, 1e-4}) {
            const Budget budget =
                meet_budget(device_, stage(), scene_, defaults_, known, max_error);
            RenderSettings with = defaults_;
            with.methods = budget.plan.methods;
            with.max_depth = budget.plan.max_depth;
            Renderer renderer(device_, stage(), scene_, with);
            renderer.render();
            chart_.budgets.push_back({max_error, to_string(budget.plan, defaults_.max_depth),
                                      budget.plan.error, budget.error, budget.is_met,
                                      time_ratio(renderer, renderer_, rounds_)});
        }
    }

    struct Measured {
        Probe probe;
        Image picture;
    };

    cl::Device device_;
    ChartSettings settings_;
    Scene scene_;
    RenderSettings defaults_;
    int rounds_ = 3;
    reference::Result truth_;
    std::optional<reference::Result> exact_;
    Renderer renderer_;
    Image default_picture_;
    std::vector<Measured> measured_;  // what --max-error may choose among
    SceneChart chart_;
};

// Times are measured no better than to 3 %, and no error is known better than its own rounding.
bool betters(const Point &a, const Point &b) {
    const bool faster = a.ratio < 0.97 * b.ratio;
    const bool slower = b.ratio < 0.97 * a.ratio;
    const bool righter = a.rmse < 0.95 * b.rmse - 1e-7;
    const bool wronger = b.rmse < 0.95 * a.rmse - 1e-7;
    return (faster && !wronger) || (righter && !slower);
}

}  // namespace

void find_fronts(std::vector<Point> &points) {
    for (Point &point : points) {
        point.on_front = std::ranges::none_of(points, [&point](const Point &other) {
            return other.kind == point.kind && betters(other, point);
        });
    }
}

SceneChart chart_scene(const cl::Device &device, const std::filesystem::path &file,
                       const ChartSettings &settings) {
    return Charting(device, file, settings).chart();
}

ordered_json json_of(const SceneChart &chart) {
    ordered_json json{{"name", chart.name},
                      {"size", {chart.width, chart.height}},
                      {"milliseconds", chart.milliseconds}};
    for (const Point &point : chart.points) {
        json["points"].push_back({{"kind", point.kind},
                                  {"name", point.name},
                                  {"default", point.is_default},
                                  {"ratio", point.ratio},
                                  {"rmse", point.rmse},
                                  {"worst_interior", point.worst_interior},
                                  {"perceptual_failures", point.perceptual_failures},
                                  {"front", point.on_front},
                                  {"picture", point.picture},
                                  {"difference", point.difference}});
    }
    json["left_out"] = ordered_json::array();
    for (const LeftOut &left : chart.left_out) {
        json["left_out"].push_back({{"method", left.method}, {"why", left.why}});
    }
    json["budgets"] = ordered_json::array();
    for (const Met &met : chart.budgets) {
        json["budgets"].push_back({{"max_error", met.max_error},
                                   {"plan", met.plan},
                                   {"predicted", met.predicted},
                                   {"measured", met.measured},
                                   {"met", met.is_met},
                                   {"ratio", met.ratio}});
    }
    return json;
}

}  // namespace stagelight::chart

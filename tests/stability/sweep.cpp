// SPDX-License-Identifier: MIT
#include "stability/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stagelight::stability {

Sweep::Sweep(Question question, std::string device)
    : question_(std::move(question)), device_(std::move(device)) {}

Sweep::~Sweep() {
    const char *folder = std::getenv("STAGELIGHT_STABILITY");
    if (folder == nullptr) {
        return;
    }
    nlohmann::ordered_json json{{"name", question_.name},       {"kind", question_.kind},
                                {"title", question_.title},     {"x_label", question_.x_label},
                                {"y_label", question_.y_label}, {"limit", question_.limit},
                                {"stated", question_.stated},   {"device", device_}};
    for (const Series &series : series_) {
        nlohmann::ordered_json points;
        for (const Point &point : series.points) {  // JSON has no infinity: null stands for it
            points.push_back({point.x, point.error});
        }
        const auto failure = std::ranges::find_if_not(
            series.points, [this](const Point &point) { return point.error <= question_.limit; });
        json["methods"].push_back(
            {{"name", series.method},
             {"sound", series.is_sound},
             {"points", points},
             {"fails_at", failure == series.points.end() ? nlohmann::ordered_json()
                                                         : nlohmann::ordered_json(failure->x)}});
    }
    std::filesystem::create_directories(folder);
    std::ofstream(std::filesystem::path(folder) / (question_.name + '.' + device_ + ".json"))
        << json.dump(1) << '\n';
}

Sweep::Series &Sweep::series_of(const std::string &method) {
    const auto found = std::ranges::find(series_, method, &Series::method);
    return found != series_.end() ? *found : series_.emplace_back(Series{method, {}, false});
}

void Sweep::add(const std::string &method, double x, double error) {
    std::vector<Point> &points = series_of(method).points;
    const double counted = std::isnan(error) ? INFINITY : error;
    const auto found = std::ranges::find(points, x, &Point::x);
    if (found != points.end()) {
        found->error = std::max(found->error, counted);
    } else {
        points.push_back({x, counted});
    }
}

std::vector<Sweep::Point> Sweep::points_to(const Series &series, double last) const {
    const auto found = std::ranges::find(series.points, last, &Point::x);
    if (found == series.points.end()) {
        throw std::logic_error(
            fmt::format("{}: {} was not tried at {}", question_.name, series.method, last));
    }
    return {series.points.begin(), found + 1};
}

void Sweep::expect_holds(const std::string &method, double last) {
    Series &series = series_of(method);
    series.is_sound = true;
    for (const Point &point : points_to(series, last)) {
        EXPECT_LE(point.error, question_.limit)
            << question_.name << ", " << device_ << ": " << method << " at " << point.x;
    }
}

void Sweep::expect_fails(const std::string &method, double last) {
    const std::vector<Point> points = points_to(series_of(method), last);
    double worst = 0;
    for (const Point &point : points) {
        worst = std::max(worst, point.error);
    }
    EXPECT_GT(worst, question_.limit) << question_.name << ", " << device_ << ": " << method
                                      << " is said to have failed by " << last;
}

}  // namespace stagelight::stability

// SPDX-License-Identifier: MIT
// How wrong each method of a choice is, from easy input to the input that breaks it.
#pragma once

#include <string>
#include <vector>

namespace stagelight::stability {

// What a sweep varies and measures, as the page tells it.
struct Question {
    std::string name;     // of the file, and of the plot: sphere_distance
    std::string kind;     // of the methods: sphere
    std::string title;    // Spheres far away
    std::string x_label;  // distance / radii
    std::string y_label;  // relative error of the distance
    double limit = 0;     // an error above it counts as a failure
    std::string stated;   // the domain that the default is meant for: "to 1e6 radii"
};

// The worst error of a method at each x, in the order in which they are added: from easy to hard,
// all of them above 0 (the axes are logarithmic). An error of 0 is fine, and so is infinity.
class Sweep {
public:
    // `device` is the one that the errors are of.
    Sweep(Question question, std::string device);
    // Writes it to the folder that STAGELIGHT_STABILITY names, if it does.
    ~Sweep();
    Sweep(const Sweep &) = delete;
    Sweep &operator=(const Sweep &) = delete;

    // Another case of a method at x: the worst counts.
    void add(const std::string &method, double x, double error);

    // Fails the test unless the method is within the limit at every x up to and with `last`.
    void expect_holds(const std::string &method, double last);
    // Fails the test unless the method has failed by `last`: so that what is told of it stays true.
    void expect_fails(const std::string &method, double last);

private:
    struct Point {
        double x, error;
    };
    struct Series {
        std::string method;
        std::vector<Point> points;
        bool is_sound = false;  // expected to hold
    };

    Series &series_of(const std::string &method);
    // The points up to and with the one at `last`, which must be there.
    std::vector<Point> points_to(const Series &series, double last) const;

    Question question_;
    std::string device_;
    std::vector<Series> series_;
};

}  // namespace stagelight::stability

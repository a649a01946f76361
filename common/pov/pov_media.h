// SPDX-License-Identifier: MIT
// Dielectrics that overlap others or hold the eye (docs/pov-ray.md, "Glass in glass").
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/bodies.h"
#include "scene/scene.h"

namespace stagelight::pov {

// How far apart the two shells of a surface are. POV-Ray skips hits nearer than 1e-4, so a smaller
// distance would hide the second shell from a ray that starts on the first.
constexpr double shell_distance = 4e-4;

// POV-Ray knows no precedence. A ray keeps a list of the interiors that it has entered and not
// left, it absorbs by all of them, and it reflects nothing where it goes from one back into
// another. So we never let the list have more than one entry, and cut each surface where the medium
// around it changes. With air around it, one surface does. With another dielectric around it, it
// becomes two shells: the outer one adds the inside's interior to the list, the inner one removes
// that of the outside. Each shell refracts and reflects the rays that come from its own medium, and
// lets those through that come from between the shells.
class Media {
public:
    // Throws UserError for a body that POV-Ray cannot have.
    explicit Media(const Scene &scene);

    // The body of a shape, or -1 for a shape that POV-Ray treats rightly by itself: it overlaps no
    // other dielectric and does not hold the eye.
    int of_sphere(std::size_t index) const { return affected(bodies_.of_sphere[index]); }
    int of_plane(std::size_t index) const { return affected(bodies_.of_plane[index]); }
    int of_triangle(std::size_t index) const { return affected(bodies_.of_triangle[index]); }

    bool have_shells() const;

    // A body's surface as an object of POV-Ray's, and the same moved outwards by shell_distance.
    struct Shape {
        std::string surface;
        std::string outer_shell;
    };
    // The objects that stand for the bodies, from their shapes by number; `shapes` has the affected
    // ones.
    std::string objects(const std::vector<Shape> &shapes) const;

private:
    bool overlaps(int body) const { return !overlapping_[static_cast<std::size_t>(body)].empty(); }
    bool holds_eye(int body) const { return holds_eye_[static_cast<std::size_t>(body)]; }
    int affected(int body) const {
        return body >= 0 && (overlaps(body) || holds_eye(body)) ? body : -1;
    }
    std::string clip(int body, int outside) const;
    void add_surfaces(int body, std::vector<std::string> &of_medium) const;

    Bodies bodies_;
    std::vector<std::vector<int>> overlapping_;  // of each body the others, ascending
    std::vector<bool> holds_eye_;                // of each body
    int eye_medium_ = -1;                        // the one that is there
};

// The scene `factor` times as large, which gives the same picture.
Scene enlarged(Scene scene, double factor);

}  // namespace stagelight::pov

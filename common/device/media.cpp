// SPDX-License-Identifier: MIT
#include "device/media.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "scene/progress.h"

namespace stagelight {
namespace {

constexpr std::size_t most_media = 32;  // bits of a uint

std::set<int> bodies_with_media(const Bodies &bodies, const Scene &scene, bool all) {
    std::set<int> found;
    for (const auto &[one, other] : bodies.meeting) {
        found.insert({one, other});
    }
    const std::vector<int> at_eye = bodies_at(scene, bodies, scene.camera.position);
    found.insert(at_eye.begin(), at_eye.end());
    for (int i = 0; i < static_cast<int>(bodies.list.size()); ++i) {
        const Body &body = bodies.list[static_cast<std::size_t>(i)];
        const Material &material = scene.materials[static_cast<std::size_t>(body.material)];
        const bool has_way_out = body.plane >= 0 || !body.is_closed;
        if (all || (has_way_out && material.absorption != glm::dvec3(0))) {
            found.insert(i);
        }
    }
    return found;
}

}  // namespace

Media::Media(const Scene &scene, bool eye_moves)
    : bodies_(bodies_of(scene)), of_body_(bodies_.list.size(), -1) {
    const std::set<std::pair<int, int>> meeting(bodies_.meeting.begin(), bodies_.meeting.end());
    const auto meet = [&meeting](int one, int other) {
        return meeting.contains({one, other}) || meeting.contains({other, one});
    };
    std::vector<int> newest;  // the bodies of the highest medium so far
    for (const int body : bodies_with_media(bodies_, scene, eye_moves)) {
        const int material = bodies_.list[static_cast<std::size_t>(body)].material;
        if (materials_.empty() || materials_.back() != material
            || std::ranges::any_of(newest, [&](int other) { return meet(body, other); })) {
            materials_.push_back(material);
            newest.clear();
        }
        newest.push_back(body);
        of_body_[static_cast<std::size_t>(body)] = static_cast<int>(materials_.size()) - 1;
    }
    if (materials_.size() > most_media) {
        warn(fmt::format(
            "{}: {} dielectrics meet; rays remember {} of them, and take the {} of the "
            "lowest precedence for bodies in air",
            scene.file.string(), materials_.size(), most_media, materials_.size() - most_media));
        const auto left = static_cast<int>(materials_.size() - most_media);
        materials_.erase(materials_.begin(), materials_.begin() + left);
        for (int &medium : of_body_) {
            medium = std::max(medium - left, -1);
        }
    }
}

std::uint32_t Media::at(const Scene &scene, const glm::dvec3 &point) const {
    std::uint32_t bits = 0;
    if (!materials_.empty()) {
        for (const int body : bodies_at(scene, bodies_, point)) {
            const int medium = of_body_[static_cast<std::size_t>(body)];
            bits |= medium < 0 ? 0 : 1U << medium;
        }
    }
    return bits;
}

}  // namespace stagelight

// SPDX-License-Identifier: MIT
// A scene's triangles, in Embree's hands.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <embree3/rtcore.h>

#include "bench/peers/lanes.h"
#include "scene/scene.h"

namespace stagelight::bench {

class EmbreeScene {
public:
    // Throws MachineError with what Embree says.
    EmbreeScene(const Scene &scene, RTCBuildQuality quality);

    RTCScene get() const { return scene_.get(); }
    double build_milliseconds() const { return build_milliseconds_; }

    // What Embree does not keep: the corners of each triangle, and the vertices' normals.
    const std::array<std::uint32_t, 3> &corners(unsigned triangle) const {
        return corners_[triangle];
    }
    const Vec<float> &normal(std::uint32_t vertex) const { return normals_[vertex]; }

    // "Embree 3.13.5, packets of 16 native: yes"
    std::string description() const;

private:
    void add_geometry(const Scene &scene, RTCBuildQuality quality);

    template <auto release> struct Release {
        void operator()(auto *object) const { release(object); }
    };
    std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>> device_;
    std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>> scene_;
    std::vector<std::array<std::uint32_t, 3>> corners_;
    std::vector<Vec<float>> normals_;
    double build_milliseconds_ = 0;
};

}  // namespace stagelight::bench

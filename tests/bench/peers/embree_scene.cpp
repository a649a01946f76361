// SPDX-License-Identifier: MIT
#include "bench/peers/embree_scene.h"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "bench/report.h"
#include "scene/errors.h"

namespace stagelight::bench {
namespace {

Vec<float> to_float(const glm::dvec3 &v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene &scene, RTCBuildQuality quality)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
    add_geometry(scene, quality);
    build_milliseconds_ = time_of([&] { rtcCommitScene(scene_.get()); });
    if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE) {
        throw MachineError(fmt::format("Embree fails with error {}", static_cast<int>(error)));
    }
}

void EmbreeScene::add_geometry(const Scene &scene, RTCBuildQuality quality) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *positions = static_cast<Vec<float> *>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec<float>), scene.vertices.size()));
    for (const Vertex &vertex : scene.vertices) {
        *positions++ = to_float(vertex.position);
        normals_.push_back(to_float(vertex.normal));
    }
    for (const Triangle &triangle : scene.triangles) {
        corners_.push_back(triangle.vertices);
    }
    auto *indices = static_cast<std::array<std::uint32_t, 3> *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof corners_[0], corners_.size()));
    std::ranges::copy(corners_, indices);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_.get(), quality);
}

std::string EmbreeScene::description() const {
    const auto property = [this](RTCDeviceProperty which) {
        return rtcGetDeviceProperty(device_.get(), which);
    };
    return fmt::format(
        "Embree {}.{}.{}, packets of 16 native: {}", property(RTC_DEVICE_PROPERTY_VERSION_MAJOR),
        property(RTC_DEVICE_PROPERTY_VERSION_MINOR), property(RTC_DEVICE_PROPERTY_VERSION_PATCH),
        property(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0 ? "yes" : "no");
}

}  // namespace stagelight::bench

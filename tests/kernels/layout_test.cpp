// SPDX-License-Identifier: MIT
#include <numeric>

#include "kernels/on_device.h"
#include "scene_types.h"

namespace stagelight::device {
namespace {

using KernelsStage01Layout = OnDevice;
INSTANTIATE_TEST_SUITE_P(On, KernelsStage01Layout, each_device(), device_name);

struct Entry {
    const char *name;
    std::size_t value;
};

#define SIZE(type) \
    { "sizeof " #type, sizeof(type) }
#define OFFSET(type, member) \
    { #type "." #member, offsetof(type, member) }

const std::vector<Entry> host_layout{
    SIZE(Camera),
    OFFSET(Camera, position),
    OFFSET(Camera, corner),
    OFFSET(Camera, right),
    OFFSET(Camera, down),
    OFFSET(Camera, sample),
    OFFSET(Camera, size),
    SIZE(GlossyMaterial),
    OFFSET(GlossyMaterial, specularity),
    SIZE(DielectricMaterial),
    OFFSET(DielectricMaterial, absorption),
    OFFSET(DielectricMaterial, ior),
    SIZE(Material),
    OFFSET(Material, color),
    OFFSET(Material, as.glossy),
    OFFSET(Material, as.dielectric),
    OFFSET(Material, texture_size),
    OFFSET(Material, texture_place),
    OFFSET(Material, texture),
    OFFSET(Material, wrap_u),
    OFFSET(Material, wrap_v),
    OFFSET(Material, type),
    SIZE(Cutout),
    OFFSET(Cutout, first),
    OFFSET(Cutout, cutoff),
    SIZE(PointLight),
    OFFSET(PointLight, position),
    OFFSET(PointLight, range),
    SIZE(DirectionalLight),
    OFFSET(DirectionalLight, direction),
    SIZE(Light),
    OFFSET(Light, color),
    OFFSET(Light, as.point),
    OFFSET(Light, as.directional),
    OFFSET(Light, type),
    SIZE(Sphere),
    OFFSET(Sphere, center),
    OFFSET(Sphere, radius),
    OFFSET(Sphere, material),
    SIZE(Plane),
    OFFSET(Plane, normal),
    OFFSET(Plane, offset),
    OFFSET(Plane, material),
    SIZE(Triangle),
    OFFSET(Triangle, vertices),
    OFFSET(Triangle, material),
    SIZE(BvhNode),
    OFFSET(BvhNode, planes),
    OFFSET(BvhNode, first),
    OFFSET(BvhNode, count),
    SIZE(RayCounts),
    OFFSET(RayCounts, shadow),
    OFFSET(RayCounts, reflection),
    OFFSET(RayCounts, refraction),
    OFFSET(RayCounts, dropped),
    OFFSET(RayCounts, cut_off),
    OFFSET(RayCounts, cut_off_weight),
};

TEST_P(KernelsStage01Layout, StructsLieOnTheDeviceAsOnTheHost) {
    std::vector<uint> indices(host_layout.size() + 1);
    std::iota(indices.begin(), indices.end(), 0U);
    const std::vector<uint> layout = build("layout.cl").run<uint>("layout", indices);
    for (std::size_t i = 0; i < host_layout.size(); ++i) {
        EXPECT_EQ(layout[i], host_layout[i].value)
            << host_layout[i].name << " differs on the device";
    }
    EXPECT_EQ(layout.back(), 0u) << "layout.cl lists more than the host does";
}

}  // namespace
}  // namespace stagelight::device

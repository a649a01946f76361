// SPDX-License-Identifier: MIT
// Dielectrics in and beside each other, looked at along an axis on which all surfaces are met
// head-on: what is seen there, from the layers of media alone.
#pragma once

#include <limits>
#include <vector>

#include "reference/scenes.h"

namespace stagelight::reference {

struct Layer {
    double ior = 1;
    dvec3 absorption{0};
    double end = std::numeric_limits<double>::infinity();  // along the axis
};

// Media one after another; the first begins nowhere, the last has no end.
struct Layers {
    std::vector<Layer> list;
    dvec3 background{1};
    int max_depth = 8;

    // What a ray sees that starts in the layer `at`, so far before its wall in the direction
    // `step`. At a wall the share F = ((n1 - n2) / (n1 + n2))^2 comes back (Fresnel, head-on; what
    // Schlick has too).
    dvec3 seen(std::size_t at, int step, double way, int depth = 0) const {
        const std::size_t beyond = at + std::size_t(step);  // wraps to none before the first
        const Layer &here = list[at];
        if (beyond >= list.size())  // a way without an end
            return background * dvec3(glm::equal(here.absorption, dvec3(0)));
        const double n1 = here.ior, n2 = list[beyond].ior;
        const double F = (n1 - n2) * (n1 - n2) / ((n1 + n2) * (n1 + n2));
        const dvec3 left = glm::exp(-here.absorption * way);
        if (depth == max_depth)
            return dvec3(0);
        return left
               * (F * seen(at, -step, width(at), depth + 1)
                  + (1 - F) * seen(beyond, step, width(beyond), depth + 1));
    }

private:
    double width(std::size_t at) const { return at == 0 ? 0 : list[at].end - list[at - 1].end; }
};

// A scene whose eye looks along -z, and what it must see.
struct LayeredScene {
    const char *what;
    Scene scene;
    Layers layers;
    std::size_t at;  // the layer of the eye
    double way;      // from there to its wall
    dvec3 expected() const { return layers.seen(at, 1, way); }
};

inline std::vector<LayeredScene> layered_scenes() {
    const dvec3 red(0.1, 1, 1), amber(0, 0.2, 0.9), pale(0.3, 0.1, 0);
    const dvec3 sky(0.5, 0.7, 1);
    const auto from = [&](double z) {
        Scene scene;
        scene.width = scene.height = 1;
        scene.camera.position = {0, 0, z};
        scene.camera.look_at = {0, 0, z - 1};
        scene.background = sky;
        return scene;
    };
    const auto add = [](Scene &scene, double z, double radius, double ior, dvec3 absorption,
                        int priority = 0) {
        Material material = glass({1, 1, 1}, ior, absorption);
        material.priority = priority;
        add_sphere(scene, {0, 0, z}, radius, material);
    };
    std::vector<LayeredScene> list;
    // Along -z: the end of a layer at the height z is at -z.
    const auto expect = [&](const char *what, const Scene &scene, std::vector<Layer> layers,
                            std::size_t at) {
        const double way = layers[at].end + scene.camera.position.z;
        list.push_back({what, scene, {std::move(layers), sky, scene.max_depth}, at, way});
    };

    Scene scene = from(0.5);
    add(scene, 0, 3, 1.5, red);
    expect("an eye in glass", scene, {{1, {}, -3}, {1.5, red, 3}, {}}, 1);

    scene = from(5);
    add(scene, 0, 1.5, 1.5, red);
    add(scene, 0.2, 0.5, 1, {});
    expect("a bubble in glass", scene,
           {{1, {}, -1.5}, {1.5, red, -0.7}, {1, {}, 0.3}, {1.5, red, 1.5}, {}}, 0);
    scene.camera.position.z = 0.4;
    scene.camera.look_at.z = -1;
    expect("an eye in a bubble in glass", scene,
           {{1, {}, -1.5}, {1.5, red, -0.7}, {1, {}, 0.3}, {1.5, red, 1.5}, {}}, 2);

    scene = from(5);
    add(scene, 0, 0.4, 1.31, {});
    add(scene, 0, 2, 1.5, pale);
    add(scene, -0.3, 1.2, 1.33, amber);
    expect("ice in whisky in glass", scene,
           {{1, {}, -2},
            {1.5, pale, -0.9},
            {1.33, amber, -0.4},
            {1.31, {}, 0.4},
            {1.33, amber, 1.5},
            {1.5, pale, 2},
            {}},
           0);

    scene = from(5);
    scene.max_depth = 3;  // as many walls as are there
    add(scene, 0.7, 1, 1.7, amber);
    add(scene, -0.5, 1.2, 1.5, red);
    expect("two balls that reach into each other: the smaller one is there", scene,
           {{1, {}, -1.7}, {1.7, amber, 0.3}, {1.5, red, 1.7}, {}}, 0);
    scene.materials[1].priority = 1;
    expect("or that of the higher priority", scene,
           {{1, {}, -1.7}, {1.7, amber, -0.7}, {1.5, red, 1.7}, {}}, 0);
    scene.materials[0].priority = 2;
    scene.camera.position.z = 0.5;
    scene.camera.look_at.z = -1;
    expect("an eye in both", scene, {{1, {}, -1.7}, {1.7, amber, 0.3}, {1.5, red, 1.7}, {}}, 1);

    scene = from(3);
    add_plane(scene, {0, 0, 1}, {0, 0, 0}, glass({1, 1, 1}, 1.33, {0.4, 0.1, 0}));
    add(scene, -0.2, 0.5, 1.31, pale);
    expect("ice that floats in water without a ground", scene,
           {{1, {}, -0.3}, {1.31, pale, 0.7}, {1.33, {0.4, 0.1, 0}}}, 0);
    scene.camera.position.z = -1;
    scene.camera.look_at.z = 5;
    scene.camera.up = {0, 1, 0};
    list.push_back({"up out of the water",
                    scene,
                    {{{1.33, {0.4, 0.1, 0}, -0.7}, {1.31, pale, 0.3}, {}}, sky, scene.max_depth},
                    0,
                    0.3});
    return list;
}

}  // namespace stagelight::reference

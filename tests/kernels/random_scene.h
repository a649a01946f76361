// SPDX-License-Identifier: MIT
// Scenes without a pattern, whose numbers are floats, so that device and reference get the same.
#pragma once

#include "device/scene_needs.h"
#include "reference/scenes.h"
#include "scene/scene.h"

namespace stagelight {

struct RandomScene {
    bool triangles = false;
    bool point_lights = false;
    bool directional_light = false;
};

// Within about 10 units of the origin: spheres, planes, and on demand smooth, textured
// triangles, two point lights (one at the centre of a sphere) and a directional one.
// Each shape has a material of its own; the counts are the same for each scene.
Scene random_scene(reference::Dice &dice, const RandomScene &with);

// What all of them need of a kernel of that stage.
SceneNeeds needs_for(const RandomScene &with, int stage);

}  // namespace stagelight

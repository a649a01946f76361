// SPDX-License-Identifier: MIT
// Choices that a tracer has, each with its methods: --method KIND=NAME.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "device/scene_needs.h"
#include "image/transfer.h"

namespace stagelight {

// The first stage that has glass.
constexpr int glass_stage = 4;
// The first that has textures.
constexpr int texture_stage = 6;
// The first that decodes textures and encodes what it shows.
constexpr int gamma_stage = 8;
// The first that has a tree of boxes, walked by one ray.
constexpr int tree_stage = 9;
// The first that traces rays side by side.
constexpr int packet_stage = 10;

struct Method {
    std::string kind;
    std::string name;
    int first_stage = 1;  // the number of the stage that teaches it
    std::string options;  // what kernels are built with; empty for the default, and the host's
    std::string source;   // where it comes from
};

// What there is from stage 1 to `stage`; of each kind the first is the default.
std::vector<Method> methods_of(int stage);

// What was chosen, by kind; a kind that is missing stands for its default.
using Methods = std::map<std::string, std::string>;

// What kernel_source takes for a scene: one without textures has nothing to filter, and one without
// a smooth mesh no terminator.
Methods files_of(Methods methods, const SceneNeeds &needs);

// The name that was chosen for a kind, or its default at `stage`.
std::string choice(const Methods &methods, const std::string &kind, int stage = cutoff_stage);

// The choices, and for each other kind that the stage has, its default.
Methods with_defaults(Methods methods, int stage);

// Adds a choice "KIND=NAME". Throws UserError with the list of what `stage` has, or with the first
// stage that has the choice.
void choose_method(Methods &methods, const std::string &choice, int stage);

// Whether the choice between the methods of a kind can change the picture or the time of a scene of
// those needs: Fresnel's can't where there is no glass.
bool matters(const std::string &kind, const SceneNeeds &needs);

// What kernels are built with for the chosen methods.
std::string options_of(const Methods &methods);

// Whether light ends on a smooth mesh otherwise than on its facets (kind "terminator").
bool has_smooth_shadows(const Methods &methods);

// Rays are cut off that carry less than one part in so many of a pixel; 0 for none (kind "depth").
int cutoff_of(const Methods &methods);

// The curve that texels are decoded with on load (kind "decode"), and the one that a picture is
// encoded with where it is shown or stored in few bits ("encode"): none before stage 08.
Transfer decode_of(int stage, const Methods &methods);
Transfer encode_of(int stage, const Methods &methods);

}  // namespace stagelight

// SPDX-License-Identifier: MIT
// Dielectrics in and beside each other, and eyes in them.
#include "reference/layers.h"

namespace stagelight::reference {
namespace {

TEST(ReferenceStage04Media, AreThereByPrecedence) {
    for (const LayeredScene &it : layered_scenes()) {
        SCOPED_TRACE(it.what);
        const dvec3 eye = it.scene.camera.position;
        expect_near(seen(it.scene, ray(eye, it.scene.camera.look_at - eye),
                         {.max_depth = it.scene.max_depth}),
                    it.expected(), 1e-12);
    }
}

}  // namespace
}  // namespace stagelight::reference

// SPDX-License-Identifier: MIT
// Exercise 06.3: a sphere whose picture is a landscape.

// kernels/trace.cl
// #region hit_surface
#define BUMP_HEIGHT 0.08f   // of white over black, radii
#define BUMP_STEP 0.0123f  // radians: of 512 texels around, one
            Surface surface = surface_at(scene, incoming.ray, hit);
            const Material bumpy = scene->materials[surface.material];
            if (hit.shape == SHAPE_SPHERE && bumpy.texture >= 0) {
                // your turn: surface.normal
            }
// #endregion hit_surface

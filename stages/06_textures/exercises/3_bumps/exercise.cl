// SPDX-License-Identifier: MIT
// #stub
// Exercise 06.3: a sphere whose picture is a landscape.
// #solution
// Exercise 06.3, solved: the normal of the plane through four neighbours, each lifted to its height (after Blinn,
// Simulation of Wrinkled Surfaces, 1978).
// #end

// kernels/trace.cl
// #region hit_surface
#define BUMP_HEIGHT 0.08f   // of white over black, radii
#define BUMP_STEP 0.0123f  // radians: of 512 texels around, one
            Surface surface = surface_at(scene, incoming.ray, hit);
            const Material bumpy = scene->materials[surface.material];
            if (hit.shape == SHAPE_SPHERE && bumpy.texture >= 0) {
// #stub
                // your turn: surface.normal
// #solution
                const float side = surface.from_behind ? -1.0f : 1.0f;
                const float3 outward = side * surface.normal;
                const float3 east = normalize(cross((float3)(0.0f, 1.0f, 0.0f), outward));
                const float3 north = cross(outward, east);
                const float3 ways[4] = {east, north, -east, -north};
                float3 lifted[4];
                for (int i = 0; i < 4; ++i) {
                    const float3 neighbour = normalize(outward + BUMP_STEP * ways[i]);
                    const float3 texel = texture_color(
                        &bumpy, sphere_texture_coordinates(neighbour), textures);
                    const float height = BUMP_HEIGHT * (texel.x + texel.y + texel.z) / 3.0f;
                    lifted[i] = (1.0f + height) * neighbour;
                }
                surface.normal =
                    side * normalize(cross(lifted[0] - lifted[2], lifted[1] - lifted[3]));
// #end
            }
// #endregion hit_surface

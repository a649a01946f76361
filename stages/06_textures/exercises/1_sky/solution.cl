// SPDX-License-Identifier: MIT
// Exercise 06.1, solved: a sphere without end, seen from within (Blinn and Newell, Texture and Reflection in Computer
// Generated Images, 1976).

// kernels/trace.cl
// #region miss
            const Material picture = scene->materials[scene->spheres[0].material];
            const float3 direction = incoming.ray.direction;
            // Mirrored, for u runs to the right seen from outside; and so the middle is at -z.
            const float2 place =
                sphere_texture_coordinates((float3)(direction.xy, -direction.z));
            const float3 sky = texture_color(&picture, place, textures);
            color += incoming.weight * sky;
// #endregion miss

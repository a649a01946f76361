// SPDX-License-Identifier: MIT
// #stub
// Exercise 06.1: what rays see that hit nothing.
// #solution
// Exercise 06.1, solved: a sphere without end, seen from within (Blinn and Newell, Texture and Reflection in Computer
// Generated Images, 1976).
// #end

// kernels/trace.cl
// #region miss
// #stub
            float3 sky = XYZ(scene->background);  // your turn
// #solution
            const Material picture = scene->materials[scene->spheres[0].material];
            const float3 direction = incoming.ray.direction;
            // Mirrored, for u runs to the right seen from outside; and so the middle is at -z.
            const float2 place =
                sphere_texture_coordinates((float3)(direction.xy, -direction.z));
            const float3 sky = texture_color(&picture, place, textures);
// #end
            color += incoming.weight * sky;
// #endregion miss

// SPDX-License-Identifier: MIT
// #stub
// Exercise 11.1: a lens instead of a pinhole.
// #solution
// Exercise 11.1, solved: from a point of the lens to where the middle ray meets the plane in focus (Cook, Porter and
// Carpenter, Distributed Ray Tracing, 1984).
// #end

// kernels/packets/render.cl
// #region trace_block
#define FOCUS 6.0f
#define LENS_RADIUS 0.12f
#define LENS_RAYS 32
#define GOLDEN_ANGLE 2.3999632f
    const float3 across = normalize(XYZ(camera.right));
    const float3 down = normalize(XYZ(camera.down));
    const float3 forward = cross(across, down);
    for (int packet = 0; packet < PACKETS; ++packet) {
        colors[packet] = wide3((float3)(0.0f));
    }
    for (int i = 0; i < LENS_RAYS; ++i) {
        // Evenly spread over the lens (Vogel, A Better Way to Construct the Sunflower Head, 1979).
        const float radius = LENS_RADIUS * sqrt(((float)i + 0.5f) / LENS_RAYS);
        const float lens_x = radius * cos(GOLDEN_ANGLE * (float)i);
        const float lens_y = radius * sin(GOLDEN_ANGLE * (float)i);
        WideRays bent[PACKETS];
        for (int packet = 0; packet < PACKETS; ++packet) {
            bent[packet] = rays[packet];
// #stub
            // your turn
// #solution
            const Wide3 direction = rays[packet].direction;
            const Wide distance = FOCUS / wide_dot(direction, wide3(forward));
            const Wide3 in_focus = wide_fused(distance, direction, rays[packet].origin);
            bent[packet].origin = wide_sum(rays[packet].origin, wide3(lens_x * across + lens_y * down));
            bent[packet].direction = wide_normalize(wide_difference(in_focus, bent[packet].origin));
// #end
        }
        RayCounts of_point = {0, 0, 0, 0, 0, 0};
        Wide3 seen[PACKETS];
        trace_packets(&scene, bent, seen, &of_point, textures);
        counts.shadow += of_point.shadow;
        counts.reflection += of_point.reflection;
        counts.refraction += of_point.refraction;
        counts.dropped += of_point.dropped;
        counts.cut_off += of_point.cut_off;
        counts.cut_off_weight = max(counts.cut_off_weight, of_point.cut_off_weight);
        for (int packet = 0; packet < PACKETS; ++packet) {
            colors[packet] = wide_fused((Wide)(1.0f / LENS_RAYS), seen[packet], colors[packet]);
        }
    }
// #endregion trace_block

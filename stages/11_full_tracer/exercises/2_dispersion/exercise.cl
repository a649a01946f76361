// SPDX-License-Identifier: MIT
// #stub
// Exercise 11.2: an index for each colour.
// #solution
// Exercise 11.2, solved: red, green and blue are traced one after the other, each by its index.
// #end

// kernels/packets/wide.cl
// #region packet
// A packet of rays. A lane without a ray has a t_max below 0, and hits nothing.
typedef struct WideRays {
    Wide3 origin, direction;
    Wide t_max;    // in lengths of the direction: what is hit beyond does not count
    float3 light;  // the weight that primary rays begin with
} WideRays;
// #endregion packet

// kernels/packets/trace.cl
// #region primary_weight
    store_lanes(&lanes->weight, wide3(rays->light));
// #endregion primary_weight

// kernels/dielectric.cl
// #region at_wall
#define DISPERSION 0.06f
// #stub
    const float ior = glass->ior;  // your turn
// #solution
    const float3 carried = incoming->weight;
    const float ior = carried.x > 0.0f   ? glass->ior - DISPERSION
                      : carried.z > 0.0f ? glass->ior + DISPERSION
                                         : glass->ior;
// #end
    const Interface interface = interface_at(surface, incoming->ray.direction, ior / outside.ior);
// #endregion at_wall

// kernels/packets/render.cl
// #region trace_block
// #stub
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet].light = (float3)(1.0f);  // your turn
    }
    trace_packets(&scene, rays, colors, &counts, textures);
// #solution
    for (int packet = 0; packet < PACKETS; ++packet) {
        colors[packet] = wide3((float3)(0.0f));
    }
    for (int channel = 0; channel < 3; ++channel) {
        WideRays of_channel[PACKETS];
        for (int packet = 0; packet < PACKETS; ++packet) {
            of_channel[packet] = rays[packet];
            of_channel[packet].light = (float3)(channel == 0, channel == 1, channel == 2);
        }
        RayCounts traced = {0, 0, 0, 0, 0, 0};
        Wide3 seen[PACKETS];
        trace_packets(&scene, of_channel, seen, &traced, textures);
        counts.shadow += traced.shadow;
        counts.reflection += traced.reflection;
        counts.refraction += traced.refraction;
        counts.dropped += traced.dropped;
        counts.cut_off += traced.cut_off;
        counts.cut_off_weight = max(counts.cut_off_weight, traced.cut_off_weight);
        for (int packet = 0; packet < PACKETS; ++packet) {
            colors[packet] = wide_sum(colors[packet], seen[packet]);
        }
    }
// #end
// #endregion trace_block

// SPDX-License-Identifier: MIT
// Exercise 11.2: an index for each colour.

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
    const float ior = glass->ior;  // your turn
    const Interface interface = interface_at(surface, incoming->ray.direction, ior);
// #endregion at_wall

// kernels/packets/render.cl
// #region trace_block
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet].light = (float3)(1.0f);  // your turn
    }
    trace_packets(&scene, rays, colors, &counts, textures);
// #endregion trace_block

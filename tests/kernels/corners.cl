// SPDX-License-Identifier: MIT
// The corners of triangles as they are stored.
#include "scene.cl"

typedef struct Corners {
    float4 corners[3];
} Corners;

__kernel void corners(__global Corners *results, __global const StoredFacet *facets) {
    const size_t i = get_global_id(0);
    for (int k = 0; k < 3; ++k) {
        results[i].corners[k] = (float4)(LOAD_COORDINATES(facets[i].corners[k]), 0.0f);
    }
}

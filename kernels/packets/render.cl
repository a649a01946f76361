// SPDX-License-Identifier: MIT
// Introduced by stage 10: the kernel, one work-item a block of PACKETS tiles, of WIDTH pixels each.
#include "packets/normalise/exact.cl"
#include "picture.cl"
#include "ray_counts.cl"
#include "packets/trace.cl"

// #region wide_camera
// As camera_ray, of the pixels right of and below `corner`. Those outside of the picture have no ray.
static WideRays camera_rays(const Camera *camera, const int2 corner) {
    const Wide column = (float)corner.x + LANE_X;
    const Wide row = (float)corner.y + LANE_Y;
    const Wide x = column + camera->sample.x;
    const Wide y = row + camera->sample.y;
    const Wide3 at_column = wide_sum(wide3(XYZ(camera->corner)), wide_scaled(x, wide3(XYZ(camera->right))));
    WideRays rays;
    rays.origin = wide3(XYZ(camera->position));
    rays.direction = wide_normalize(wide_sum(at_column, wide_scaled(y, wide3(XYZ(camera->down)))));
    const WideInt inside = (column < (float)camera->size.x) & (row < (float)camera->size.y);
    rays.t_max = inside ? (Wide)(INFINITY) : (Wide)(-1.0f);
    return rays;
}
// #endregion wide_camera

// #region wide_render
// Of a block, which is packets beside and below each other.
static int2 packet_place(const int packet) {
    return (int2)(packet % PACKETS_IN_ROW, packet / PACKETS_IN_ROW);
}

static void write_tile(PICTURE image, const int2 size, const int2 corner, const Wide3 colors) {
    Lanes3 lanes;
    store_lanes(&lanes, colors);
#pragma unroll
    for (int lane = 0; lane < WIDTH; ++lane) {
        const int2 pixel = corner + (int2)(lane % TILE_WIDTH, lane / TILE_WIDTH);
        if (pixel.x < size.x && pixel.y < size.y) {
            write_pixel(image, size.x, pixel, get_lane(&lanes, lane));
        }
    }
}

// Of the rows that a work-group draws, one that its neighbours do not count in at the same time.
static int row_for_counts(const int rows) {
    const int of_group = get_local_size(1) * TILE_HEIGHT * PACKETS_IN_ROW;
    return min((int)(get_group_id(1) * of_group + get_group_id(0) % of_group), rows - 1);
}

__kernel void render(PICTURE image, __global RayCounts *ray_counts, const Camera camera,
#include "scene_parameters.inc"
) {
    const int2 tile = (int2)(TILE_WIDTH, TILE_HEIGHT);
    const int2 block = (int2)(get_global_id(0), get_global_id(1)) * tile * PACKETS_IN_ROW;
    if (block.x >= camera.size.x || block.y >= camera.size.y) {
        return;
    }
    const Scene scene = {
#include "scene_members.inc"
    };
    WideRays rays[PACKETS];
    for (int packet = 0; packet < PACKETS; ++packet) {
        rays[packet] = camera_rays(&camera, block + tile * packet_place(packet));
    }
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    Wide3 colors[PACKETS];
    // #region trace_block
    trace_packets(&scene, rays, colors, &counts, textures);
    // #endregion trace_block
    // Before the pixels: an atomic waits until all that was written has arrived.
    add_ray_counts(&ray_counts[row_for_counts(camera.size.y)], counts);
    for (int packet = 0; packet < PACKETS; ++packet) {
        write_tile(image, camera.size, block + tile * packet_place(packet), colors[packet]);
    }
}
// #endregion wide_render

// SPDX-License-Identifier: MIT
// Introduced by stage 09: the kernel, one work-item a tile of WIDTH pixels.
#include "picture.cl"
#include "ray_counts.cl"
#include "wide_trace.cl"

// #region wide_camera
// As camera_ray, of the pixels right of and below `corner`. Those outside of the picture have no ray.
static WideRays camera_rays(const Camera *camera, const int2 corner) {
    const Wide column = (float)corner.x + LANE_X;
    const Wide row = (float)corner.y + LANE_Y;
    const Wide x = column + camera->sample.x;
    const Wide y = row + camera->sample.y;
    const Wide3 at_column = wide_sum(wide3(camera->corner.xyz),
                                     wide_scaled(x, wide3(camera->right.xyz)));
    WideRays rays;
    rays.origin = wide3(camera->position.xyz);
    rays.direction = wide_normalized(
        wide_sum(at_column, wide_scaled(y, wide3(camera->down.xyz))));
    const WideInt inside = (column < (float)camera->size.x) & (row < (float)camera->size.y);
    rays.limit = inside ? (Wide)(INFINITY) : (Wide)(-1.0f);
    return rays;
}
// #endregion wide_camera

// #region wide_render
// Of the rows that a work-group draws, one that its neighbours do not count in at the same time.
static int row_for_counts(const int rows) {
    const int of_group = get_local_size(1) * TILE_HEIGHT;
    return min((int)(get_group_id(1) * of_group + get_group_id(0) % of_group), rows - 1);
}

__kernel void render(PICTURE image, __global RayCounts *ray_counts, const Camera camera,
                     SCENE_PARAMETERS) {
    const int2 corner = (int2)(get_global_id(0) * TILE_WIDTH, get_global_id(1) * TILE_HEIGHT);
    if (corner.x >= camera.size.x || corner.y >= camera.size.y) {
        return;
    }
    const Scene scene = SCENE_ARGUMENTS;
    RayCounts counts = {0, 0, 0, 0, 0, 0};
    Lanes3 colors;
    store_lanes(&colors,
                trace_tile(&scene, camera_rays(&camera, corner), &counts TEXTURE_ARGUMENT));
    for (int lane = 0; lane < WIDTH; ++lane) {
        const int2 pixel = corner + (int2)(lane % TILE_WIDTH, lane / TILE_WIDTH);
        if (pixel.x < camera.size.x && pixel.y < camera.size.y) {
            write_pixel(image, camera.size.x, pixel, get_lane(&colors, lane));
        }
    }
    add_ray_counts(&ray_counts[row_for_counts(camera.size.y)], counts);
}
// #endregion wide_render

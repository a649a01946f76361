// SPDX-License-Identifier: MIT
// #stub
// Exercise 09.1: how many nodes of the tree were looked into for each pixel.
// #solution
// Exercise 09.1, solved: a node that a ray looks into is counted in its hit.
// #end

// kernels/ray.cl
// #region hit
typedef struct Hit {
    float distance;  // along the ray; INFINITY when nothing was hit
    Shape shape;
    int index;  // of the sphere, plane or triangle
    float2 barycentric;  // the weights of the triangle's second and third vertex
    uint nodes;  // that were looked into
} Hit;

#define HOT 64

// From black through red and yellow to white.
static float3 heat(const uint nodes) {
    const float share = min(3.0f * (float)nodes / HOT, 3.0f);
    return clamp(share - (float3)(0.0f, 1.0f, 2.0f), (float3)(0.0f), (float3)(1.0f));
}

// Where and what a ray has hit, as shading wants it: both normals face the eye.
typedef struct Surface {
    float3 position;
    float3 normal;            // for shading; unit length
    float3 geometric_normal;  // unit length
    bool from_behind;         // seen from inside a sphere or a mesh, or from under a plane
    int material;
    float ray_offset;  // how far off the surface a new ray starts
    float2 texture_coordinates;
} Surface;
// #endregion hit

// kernels/closest_hit.cl
// #region closest_hit
static Hit closest_hit(const Scene *scene, const Ray ray) {
    Hit closest;
    closest.distance = INFINITY;
    closest.shape = SHAPE_NONE;
    closest.nodes = 0;
    for (int i = 0; i < scene->plane_count; ++i) {
        const Plane plane = scene->planes[i];
        keep_closer(&closest, intersect_ray_plane(ray, XYZ(plane.normal), plane.offset), SHAPE_PLANE,
                    i);
    }
    closest_shape(scene, ray, &closest);
    return closest;
}
// #endregion closest_hit

// kernels/render.cl
// #region render_pixel
    const Ray primary = camera_ray(&camera, pixel);
    const Hit hit = closest_hit(&scene, primary);
    write_pixel(image, camera.size.x, pixel, heat(hit.nodes));
// #endregion render_pixel

// kernels/tree.cl
// #region look_into
        __global const BvhNode *node = &scene->bvh_nodes[nodes[bottom]];
// #stub
        // your turn
// #solution
        ++closest->nodes;
// #end
// #endregion look_into

// SPDX-License-Identifier: MIT
// #stub
// Exercise 05.3: where shadow rays start on a mesh that stands for something round.
// #solution
// Exercise 05.3, solved: the point is lifted to the tangent planes of the three corners, each by its weight.
// #end

// kernels/trace.cl
// #region direct
// #stub
                Surface rounded = surface;
                if (hit.shape == SHAPE_TRIANGLE) {
                    // your turn: rounded.position
                }
// #solution
                // Hanika, Hacking the Shadow Terminator (Ray Tracing Gems II, 2021, chapter 4). What is
                // above a plane, in a hollow, stays: it would be pressed below the facet.
                Surface rounded = surface;
                if (hit.shape == SHAPE_TRIANGLE) {
                    const Triangle triangle = scene->triangles[hit.index];
                    const float2 bc = hit.barycentric;
                    const float weights[3] = {1.0f - bc.x - bc.y, bc.x, bc.y};
                    const float side = surface.from_behind ? -1.0f : 1.0f;
                    for (int i = 0; i < 3; ++i) {
                        const float3 normal = side * XYZ(scene->vertex_normals[triangle.vertices[i]]);
                        const float3 corner = triangle_corner(scene, hit.index, i);
                        const float height = dot(surface.position - corner, normal);
                        rounded.position -= weights[i] * min(height, 0.0f) * normal;
                    }
                }
// #end
                color += weight * direct_light(scene, &rounded, counts);
// #endregion direct

// SPDX-License-Identifier: MIT
// #stub
// Exercise 03.3: the shares of a material, to depend on the angle.
// #solution
// Exercise 03.3, solved: Schlick's rise (An Inexpensive BRDF Model for Physically-based Rendering, 1994), for
// metal from its colour, for varnish from its specularity.
// #end

// kernels/shade.cl
// #region shade_shares
// #stub
    // your turn
    const float reflected = reflected_share(&material);
    if (reflected > 0.0f) {
        spawn_reflected(stack, incoming, surface, reflected * weight, counts);
    }
    const float diffuse = 1.0f - reflected;
// #solution
    const float slope = 1.0f + dot(incoming->ray.direction, surface->normal);
    const float rise = slope * slope * slope * slope * slope;
    const float head_on = reflected_share(&material);
    float diffuse = 1.0f - head_on;
    if (material.type == MATERIAL_MIRROR) {
        const float3 color = XYZ(material.color);
        const float3 reflected = color + rise * (1.0f - color);
        spawn_reflected(stack, incoming, surface, reflected * incoming->weight, counts);
    } else if (head_on > 0.0f) {
        const float reflected = head_on + rise * (1.0f - head_on);
        spawn_reflected(stack, incoming, surface, reflected * incoming->weight, counts);
        diffuse = 1.0f - reflected;
    }
// #end
    *direct_weight = diffuse * weight;
    return diffuse > 0.0f;
// #endregion shade_shares

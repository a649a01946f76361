// SPDX-License-Identifier: MIT
// #stub
// Exercise 01.4: from each sphere another one is taken away.
// #solution
// Exercise 01.4, solved: what is inside one interval of the ray and not inside another (Roth, Ray Casting for
// Modeling Solids, Computer Graphics and Image Processing 18, 1982).
// #end

// kernels/sphere/geometric.cl
// #region ray_sphere
#define BITE_TOWARDS (float3)(0.48f, 0.6f, 0.64f)  // unit length
#define BITE_SHARE 0.7f

// #stub
// The distance to the nearest wall ahead of what is left of the sphere; INFINITY for none.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    // your turn
    const float3 to_center = center - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 perpendicular = to_center - nearest * ray.direction;
    const float half_chord_squared = radius * radius - dot(perpendicular, perpendicular);
    if (half_chord_squared < 0.0f) {
        return INFINITY;
    }
    const float half_chord = sqrt(half_chord_squared);
    const bool inside = dot(to_center, to_center) < radius * radius;
    const float distance = inside ? nearest + half_chord : nearest - half_chord;
    return distance > 0.0f ? distance : INFINITY;
}
// #solution
// Where the ray, behind its origin too, enters a sphere and leaves it; INFINITY twice for a miss, which no
// number is between.
static float2 ray_within(const Ray ray, const float3 center, const float radius) {
    const float3 to_center = center - ray.origin;
    const float nearest = dot(to_center, ray.direction);
    const float3 perpendicular = to_center - nearest * ray.direction;
    const float half_chord_squared = radius * radius - dot(perpendicular, perpendicular);
    if (half_chord_squared < 0.0f) {
        return (float2)(INFINITY);
    }
    const float half_chord = sqrt(half_chord_squared);
    return (float2)(nearest - half_chord, nearest + half_chord);
}

static bool is_between(const float distance, const float2 ends) {
    return ends.x < distance && distance < ends.y;
}

// The distance to the nearest wall ahead of what is left of the sphere; INFINITY for none.
static float intersect_ray_sphere(const Ray ray, const float3 center, const float radius) {
    const float2 body = ray_within(ray, center, radius);
    const float2 bite = ray_within(ray, center + radius * BITE_TOWARDS, BITE_SHARE * radius);
    const float walls[4] = {body.x, body.y, bite.x, bite.y};
    float closest = INFINITY;
    for (int i = 0; i < 4; ++i) {
        const bool there = i < 2 ? !is_between(walls[i], bite) : is_between(walls[i], body);
        if (there && walls[i] > 0.0f && walls[i] < closest) {
            closest = walls[i];
        }
    }
    return closest;
}
// #end
// #endregion ray_sphere

// kernels/surface.cl
// #region sphere_surface
// #stub
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = sphere.center.xyz;
    const float3 position = ray.origin + hit.distance * ray.direction;
    surface->normal = normalize(position - center);  // your turn
    surface->position = center + sphere.radius * surface->normal;
    surface->geometric_normal = surface->normal;
    surface->material = sphere.material;
}
// #solution
// The distance does not say which wall it leads to: the nearer one. The bite's normal points to its centre,
// out of the solid.
static void sphere_surface(Surface *surface, const Sphere sphere, const Ray ray, const Hit hit) {
    const float3 center = sphere.center.xyz;
    const float3 bite_center = center + sphere.radius * BITE_TOWARDS;
    const float bite_radius = BITE_SHARE * sphere.radius;
    const float3 position = ray.origin + hit.distance * ray.direction;
    const float off_body = fabs(length(position - center) - sphere.radius);
    const float off_bite = fabs(length(position - bite_center) - bite_radius);
    if (off_body <= off_bite) {
        surface->normal = normalize(position - center);
        surface->position = center + sphere.radius * surface->normal;
    } else {
        surface->normal = normalize(bite_center - position);
        surface->position = bite_center - bite_radius * surface->normal;
    }
    surface->geometric_normal = surface->normal;
    surface->material = sphere.material;
}
// #end
// #endregion sphere_surface

// SPDX-License-Identifier: MIT
// Core exercise 05 triangle: where a ray meets a triangle.

// kernels/triangle.cl
// #region moeller_trumbore
// In lengths of `along`, INFINITY for a miss; and the weights of the second and third corner.
static float moeller_trumbore(const float3 origin, const float3 along, const Edges triangle, float2 *barycentric) {
    *barycentric = (float2)(0.0f);
    return INFINITY;  // your turn
}
// #endregion moeller_trumbore

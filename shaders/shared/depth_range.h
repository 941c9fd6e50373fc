#pragma once
// How far depths in opaque matter (physics/depth.glsl) go on from the surface: what differences two voxels wide see of values
// that are interpolated.

#ifdef __cplusplus
namespace eikonal::gpu {
#endif

const float kLeastDepth = -2.5;
const float kMostDepth = 3.5;

#ifdef __cplusplus
} // namespace eikonal::gpu
#endif

#pragma once

#ifdef __cplusplus
namespace eikonal::gpu {
#endif

const int kBrickVoxels = 4;  // edge of a brick of the field pyramid [voxels] (common/field_pyramid.h)

#ifdef __cplusplus
} // namespace eikonal::gpu
#endif

#pragma once

#ifdef __cplusplus
namespace eikonal::gpu {
#endif

const int kBrickVoxels = 4;  // edge of a brick of the field pyramid [voxels] (common/field_pyramid.h)
const int kNoClearance = 128;  // in a byte: so much more for bricks to the next that stops flights, less to the next that does not

#ifdef __cplusplus
} // namespace eikonal::gpu
#endif

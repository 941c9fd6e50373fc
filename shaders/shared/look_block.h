#pragma once
// What the ways to look at an image need beyond it.

#ifdef __cplusplus
#include <cstddef>

namespace eikonal::gpu {
#endif

const int kUniformLook = 2;
const int kImagePicture = 0;

#ifdef __cplusplus
struct LookBlock {
#else
layout(std140, binding = kUniformLook) uniform LookBlock {
#endif
    int sliceAxis;        // 0, 1, 2: the plane lies across x, y, z
    float slicePosition;  // along that axis [scene units]
    float lowest;         // value that the first colour stands for
    float highest;        // value that the last colour stands for
};

#ifdef __cplusplus
static_assert(sizeof(LookBlock) == 16);

} // namespace eikonal::gpu
#endif

// What splats of patches share: the sums, and the part of a voxel that light can be in.
#include "lightsim/bake.glsl"
#include "lightsim/sums.glsl"
#include "fields/fields.glsl"

// Share of a voxel that light can be in.
float freeShare(ivec3 voxel) {
#ifdef EFFECT_OPAQUE
    return 1.0 - shareOfDepth(texelFetch(opaqueGrid, voxel, 0).a);
#else
    return 1.0;
#endif
}

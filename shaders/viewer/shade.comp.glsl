// What every ray of a tile sees at its end, and its radiance at the camera.
#include "viewer/end_of_ray.glsl"

#ifdef EFFECT_ROUGHNESS
#include "shared/reflection_blocks.h"

layout(std430, binding = kStorageReflections) readonly buffer Reflections { PixelReflections reflections[]; };

float raySpread(uint index) {
    return reflections[index].spread;
}
#else
float raySpread(uint index) {
    return 0.0;
}
#endif

layout(local_size_x = kRaysPerGroup) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    RayState ray = loadRay(min(index, view.rayCount - 1u));
    if (index >= view.rayCount || !isFollowed(ray)) {
        return;
    }
    seeEnd(ray, raySpread(index));
    storeRows(index, rowsOf(ray), kSeenRow, kCrossingRow + 1);
}

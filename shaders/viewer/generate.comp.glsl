// Begins the rays of a tile, and lists those that have a way through the domain before them.
#include "viewer/begin_ray.glsl"
#include "viewer/ray_lists.glsl"

layout(local_size_x = kRaysPerGroup) in;

const uint kNoRayToBegin = 0xffffffffu;

#ifdef RAYS_GIVEN
uint rayToBegin() {
    uint index = gl_GlobalInvocationID.x;
    return index < view.rayCount ? index : kNoRayToBegin;
}
#else
#include "viewer/picture_order.glsl"

uint rayToBegin() {
    return rayInPictureOrder(gl_WorkGroupID.x, gl_LocalInvocationIndex, kNoRayToBegin);
}
#endif

// What is to be listed of a ray.
uint generateRay(uint index) {
    RayState ray = beginRay(index);
    storeWholeRay(index, ray);
    return ray.status == kMarching ? index | kIsPlain : kNoEntry;
}

void main() {
    uint index = rayToBegin();
    bool generates = index != kNoRayToBegin && isFollowed(loadRay(index));
    listAtOwnPlace(generates ? generateRay(index) : kNoEntry);
}

// A slice of rays on which nothing acts but the index: all that can happen to one is that it leaves the domain.
#include "viewer/stretch.glsl"
#include "viewer/event.glsl"

uint marchFreely(uint entry) {
    rayIndex = entry & ~kIsPlain;
    RayState ray = loadRay(rayIndex);
    uint left = view.stepsPerSlice;
    do {
        bool leaves = followStretch(ray, left);
        if (leaves) {
            takeEventfulStep(ray);
            left -= 1u;
        }
    } while (left > 0u && ray.status == kMarching);
    return passOn(ray, false);
}

void main() {
    listRays(isListed() ? marchFreely(listedEntry()) : kNoEntry);
}

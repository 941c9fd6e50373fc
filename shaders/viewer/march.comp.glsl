// The first slice of rays through the domain: a stretch of each, up to a step in which something happens.
#include "viewer/stretch.glsl"

void main() {
    if (!isListed()) {
        return;
    }
    rayIndex = listedEntry() & ~kIsPlain;
    RayState ray = loadRay(rayIndex);
    loadBoundary();
    stopInsideOpaque(ray);
    uint left = view.stepsPerSlice;
    bool eventful = followStretch(ray, left);
    passOn(ray, eventful);
}

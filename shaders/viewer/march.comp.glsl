// The first slice of rays through the domain: a stretch of each, up to a step in which something happens.
#include "viewer/stretch.glsl"

uint march(uint entry) {
    rayIndex = entry & ~kIsPlain;
    RayState ray = loadRay(rayIndex);
    loadBoundary();
    stopInsideOpaque(ray);
    uint left = stepsOfSlice(takenHead.count);
    bool eventful = followStretch(ray, left);
    return passOn(ray, eventful);
}

void main() {
    uint entry = listedEntry();
    listRay(entry == kNoEntry ? kNoEntry : march(entry));
}

// Every slice but the first of rays through the domain: the step in which something happens, and a stretch up to the next one.
// Rays that do not fill the device go on from event to event, for nothing is won by listing them anew.
#include "viewer/stretch.glsl"
#include "viewer/event.glsl"

uint marchOn(uint entry) {
    rayIndex = entry & ~kIsPlain;
    RayState ray = loadRay(rayIndex);
    loadBoundary();
    bool eventful = entry == rayIndex;
    bool goesOn = takenHead.count <= view.fewRays;
    uint left = stepsOfSlice(takenHead.count);
    do {
        if (eventful) {
            takeEventfulStep(ray);
            left -= 1u;
        }
        eventful = followStretch(ray, left);
    } while (goesOn && eventful && left > 0u);
    return passOn(ray, eventful);
}

void main() {
    uint entry = listedEntry();
    listRay(entry == kNoEntry ? kNoEntry : marchOn(entry));
}

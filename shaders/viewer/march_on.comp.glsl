// Every slice but the first of rays through the domain: the step in which something happens, and a stretch up to the next one.
#include "viewer/stretch.glsl"
#include "viewer/event.glsl"

// So many rays do not fill a device. They go on from event to event, for nothing is won by listing them anew.
const uint kFewRays = 1024u;

uint marchOn(uint entry) {
    rayIndex = entry & ~kIsPlain;
    RayState ray = loadRay(rayIndex);
    loadBoundary();
    bool eventful = entry == rayIndex;
    bool goesOn = takenHead.count <= kFewRays;
    uint left = view.stepsPerSlice;
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
    listRay(isListed() ? marchOn(listedEntry()) : kNoEntry);
}

// A stretch of a ray's way: straight flights where nothing bends it, else steps, up to one in which something happens.
//
// A vector of rays pays for every line between two turns of a loop, whether or not one of its rays takes that branch, and for
// one turn of every loop. So there is little here but what most steps need, and loops end with the last turn that one needs.
#include "viewer/steps.glsl"

bool isPlain(RayState ray, uint left) {
    return left > 0u && ray.status == kMarching && !looksAhead(ray);
}

uint stepsLeft(RayState ray, uint left) {
    return min(left, (evaluationsLeft(ray) + kEvaluationsPerStep - 1u) / kEvaluationsPerStep);
}

#ifdef STEPS_FREELY
#include "viewer/free_steps.glsl"
#else
#include "viewer/plain_steps.glsl"
#endif

// At most `left` flights and steps. Whether something happens in the next step; else the ray or the slice has ended.
bool followStretch(inout RayState ray, inout uint left) {
    bool eventful = false;
    do {
        flyAhead(ray, left);
        eventful = stepAlong(ray, left);
    } while (!eventful && left > 0u && ray.status == kMarching);
    return eventful;
}

// What is to be listed for the next slice.
uint passOn(RayState ray, bool eventful) {
    storeRay(ray);
    return ray.status != kMarching ? kNoEntry : eventful ? rayIndex : rayIndex | kIsPlain;
}

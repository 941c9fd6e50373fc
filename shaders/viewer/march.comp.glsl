// Rays through the domain, a slice of their steps: straight flights where nothing bends them, else steps, up to one in which
// something happens. That one is left to viewer/event.comp.glsl.
//
// A vector of rays pays for every line between two turns of a loop, whether or not one of its rays takes that branch, and for
// one turn of every loop. So there is little here but what most steps need, and loops end with the last turn that one needs.
#include "viewer/steps.glsl"

bool isPlain(RayState ray, uint left) {
    return left > 0u && ray.status == kMarching && !looksAhead(ray);
}

// Steps until something happens in one, which is not taken then: true. Or the ray may fly, or has come to the slice's end.
bool stepAlong(inout RayState ray, inout uint left) {
    bool eventful = false;
    bool goes = isPlain(ray, left);
    do {
        float ds = usualStepAt(ray.x);
        Step next = stepOf(ray, stepRay(Ray(ray.x, ray.w), ds), ds);
        ray.evaluations += goes ? kEvaluationsPerStep : 0u;
        eventful = goes && isEventful(ray, next);
        if (goes && !eventful) {
            move(ray, next);
            followBoundary(ray, next.nBefore, next.inBand, next.middle, next.w, next.optics);
            passStep(ray, next);
            endRay(ray);
            left -= 1u;
        }
        goes = goes && !eventful && isPlain(ray, left);
    } while (goes);
    return eventful;
}

void main() {
    if (!isListed(kPlainRays)) {
        return;
    }
    rayIndex = listedRay(kPlainRays);
    RayState ray = rays[rayIndex];
    loadSteepest();
    stopInsideOpaque(ray);
    uint left = stepsPerSlice;
    bool eventful = false;
    do {
        flyAhead(ray, left);
        eventful = stepAlong(ray, left);
    } while (!eventful && left > 0u && ray.status == kMarching);
    storeRay(ray);
    if (ray.status == kMarching) {
        listRay(kEventfulRays, eventful ? rayIndex : rayIndex | kSliceEnded);
    }
}

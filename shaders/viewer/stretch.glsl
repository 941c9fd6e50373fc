// A stretch of a ray's way: straight flights where nothing bends it, else steps, up to one in which something happens: at a
// boundary, in matter, at opaque matter or the end of the domain.
//
// A vector of rays pays for every line between two turns of a loop, whether or not one of its rays takes that branch, and for
// one turn of every loop. So there is little here but what most steps need, and loops end with the last turn that one needs.
#include "viewer/steps.glsl"

layout(local_size_x = kRaysPerGroup) in;

// Steps until something happens in one, which is not taken then: true. Or the ray may fly, or has come to the slice's end.
bool stepAlong(inout RayState ray, inout uint left) {
    bool eventful = false;
    uint most = stepsLeft(ray, left);
    uint taken = 0u;
    if (isPlain(ray, most)) {
        float perW = 1.0 / length(ray.w);
        do {
            float ds = usualStepAt(ray.x);
            RayStep onward = stepRay(Ray(ray.x, ray.w), perW, ds);
            Step next = stepOf(ray, onward, ds);
            if (isEventful(ray, next)) {
                eventful = true;
                break;
            }
            taken += 1u;
            perW = onward.perW;
            move(ray, next);
            followBoundary(ray, next);
            passStep(ray, next);
            endFaintRay(ray);
        } while (isPlain(ray, most - taken));
    }
    left -= taken;
    ray.evaluations += (taken + uint(eventful)) * kEvaluationsPerStep;
    endRay(ray);
    return eventful;
}

// At most `left` flights and steps. Whether something happens in the next step; else the ray or the slice has ended.
bool followStretch(inout RayState ray, inout uint left) {
    bool eventful = false;
    do {
        flyAhead(ray, left);
        eventful = stepAlong(ray, left);
    } while (!eventful && left > 0u && ray.status == kMarching);
    return eventful;
}

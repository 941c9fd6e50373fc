// Steps of rays to which something may happen: a boundary, matter, opaque matter, or the end of the domain.

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

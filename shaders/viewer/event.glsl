// A step in which something happens: a boundary ends and splits light, opaque matter is met, or the domain ends.
#include "viewer/steps.glsl"

#ifdef INTEGRATOR_LEAPFROG

// Evaluates the field where the ray is, in the middle of its step, and turns it.
void kick(inout RayState ray, inout Step taken, float ds) {
    taken.optics = sampleOptics(ray.x);
    taken.inBand = inBoundary(ray.x);
    taken.w = ray.w;
    ray.evaluations += 1u;
    taken.nMean = taken.optics.n;
#ifdef EFFECT_REFRACTION
    taken.w = kickByLength(Ray(ray.x, ray.w), taken.optics.gradN, 0.5 * ds).w;
    ray.w = kickByLength(Ray(ray.x, ray.w), taken.optics.gradN, ds).w;
#endif
}

// A step that may end at the face, which the first half of it may reach.
Step carefulStep(inout RayState ray) {
    Step taken;
    float usual = usualStepAt(ray.x);
    float ds = nextStepLength(ray);
    taken.start = ray.x;
    taken.nBefore = ray.n;
    taken.nMean = ray.n;
    taken.w = ray.w;
    taken.wStart = ray.w;
    taken.optics = Optics(ray.n, vec3(0.0));
    taken.inBand = true;
    taken.first = drift(ray, 0.5 * ds);
    taken.middle = ray.x;
    taken.second = 0.0;
    if (ray.status == kMarching) {
        kick(ray, taken, ds);
        taken.second = ds < usual ? lastDrift(ray, 0.5 * ds) : drift(ray, 0.5 * ds);
    }
    taken.end = ray.x;
    taken.wEnd = ray.w;
    return taken;
}

#else

// A step that may end at the face: there it is taken again until it has the length that ends on it.
Step carefulStep(inout RayState ray) {
    Ray start = Ray(ray.x, ray.w);
    float perW = 1.0 / length(ray.w);
    float usual = usualStepAt(ray.x);
    float ds = nextStepLength(ray);
    bool last = ds < usual;
    RayStep next = stepRay(start, perW, ds);
    for (int i = 0; i < kFaceTrials && (last || outside(next.ray.x)); ++i) {
        last = true;
        ds = clamp(ds + signedDistanceToFace(next.ray), kShortestStep * usual, usual);
        next = stepRay(start, perW, ds);
    }
    Step taken = stepOf(ray, next, ds);
    ray.evaluations += kEvaluationsPerStep;
    if (signedDistanceToFace(next.ray) < kShortestStep * view.stepLength) {
        ray.status = kExited;
        taken.end = clamp(next.ray.x, domain.min, domain.max);
    }
    return taken;
}

#endif

void takeEventfulStep(inout RayState ray) {
    Step taken = carefulStep(ray);
    move(ray, taken);
    endBoundary(ray, taken);
    cutAtOpaque(ray, taken);
    passStep(ray, taken);
    endRay(ray);
}

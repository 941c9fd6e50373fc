// Reflections that are followed (docs/physics.md, section 4). Where a boundary ends, what it mirrors is noted and waits until
// the ray has come to its end (viewer/reflect.comp.glsl).
#include "physics/step_leapfrog.glsl"
#include "physics/mirror.glsl"
#include "shared/reflection_blocks.h"

layout(std430, binding = kStorageReflections) buffer Reflections { PixelReflections reflections[]; };

// The boundary under way: where it is steepest so far, and where it began.
struct Steepest {
    Ray ray;
    vec3 transmittance;
};
struct Start {
    Ray ray;
    vec3 transmittance;
};
Steepest steepest;
Start boundaryStart;

void loadBoundary() {
    steepest.ray = Ray(reflections[rayIndex].steepestX, reflections[rayIndex].steepestW);
    steepest.transmittance = reflections[rayIndex].steepestTransmittance;
    boundaryStart.ray = Ray(reflections[rayIndex].startX, reflections[rayIndex].startW);
    boundaryStart.transmittance = reflections[rayIndex].startTransmittance;
}

// Of a sample at x with wave vector w.
void noteSteepest(vec3 x, vec3 w, RayState ray) {
    steepest = Steepest(Ray(x, w), ray.transmittance);
}

// Of a step that begins at x with wave vector w.
void noteStart(vec3 x, vec3 w, RayState ray) {
    boundaryStart = Start(Ray(x, w), ray.transmittance);
}

void storeBoundary() {
    reflections[rayIndex].steepestX = steepest.ray.x;
    reflections[rayIndex].steepestW = steepest.ray.w;
    reflections[rayIndex].steepestTransmittance = steepest.transmittance;
    reflections[rayIndex].startX = boundaryStart.ray.x;
    reflections[rayIndex].startW = boundaryStart.ray.w;
    reflections[rayIndex].startTransmittance = boundaryStart.transmittance;
}

#ifdef EFFECT_ROUGHNESS
#include "viewer/rough_boundary.glsl"
#endif

float raySpread() {
#ifdef EFFECT_ROUGHNESS
    return reflections[rayIndex].spread;
#else
    return 0.0;
#endif
}

void spreadRay(float more) {
#ifdef EFFECT_ROUGHNESS
    reflections[rayIndex].spread += more;
#endif
}

// How the boundary that ends with wave vector w at index nEnd splits light.
BoundarySplit splitAt(Crossing crossing, vec3 w, float nEnd) {
    BoundarySplit split = crossingSplit(crossing, w, nEnd);
#ifdef EFFECT_ROUGHNESS
    float roughness = surfaceAt(steepest.ray.x).a;
    if (roughness > 0.0 && split.reflected.s > 0.0) {
        split = roughSplit(crossing, w, nEnd, roughness);
    }
#endif
    return split;
}

vec3 tintOfMirror() {
#ifdef EFFECT_TINT
    return surfaceAt(steepest.ray.x).rgb;
#else
    return vec3(1.0);
#endif
}

// What is behind the mirror has taken nothing yet from light that it reflects: `steepest` holds the transmittance that counts.
bool isWorthFollowing(RayState ray, Polarised throughput) {
    vec3 left = steepest.transmittance * (0.5 * (throughput.s + throughput.p));
    return ray.generation < view.mostGenerations && max(left.r, max(left.g, left.b)) >= view.leastReflected;
}

// The reflected ray of one that met the mirror in `met`.
Ray rayFromMirror(Ray met, vec3 away) {
    vec3 gradN = sampleOptics(met.x).gradN;
#ifdef EFFECT_ROUGHNESS
    if (surfaceAt(steepest.ray.x).a > 0.0) {
        return rayLeaving(boundaryStart.ray, met.x, gradN, away);
    }
#endif
    return rayMirrored(boundaryStart.ray, met.x, gradN);
}

// What absorption leaves of a ray that has been to the mirror and back: as much again as on its way there.
vec3 transmittanceOfReturn() {
    return steepest.transmittance * steepest.transmittance / max(boundaryStart.transmittance, vec3(1.0e-30));
}

// Lets the reflection at a boundary that ends at index nEnd wait, if it is worth it and there is room. Whether it does.
bool letWait(inout RayState ray, float nStart, float nEnd, vec3 away, Polarised throughput, float spread) {
    uint waiting = reflections[rayIndex].waiting;
    if (waiting >= uint(kMostWaiting) || !isWorthFollowing(ray, throughput)) {
        return false;
    }
    Ray met = rayAtIndex(steepest.ray, 0.5 * (nStart + nEnd), usualStepAt(steepest.ray.x));
    Ray reflected = rayFromMirror(met, away);
    ray.evaluations += uint(2 * kMirrorCorrections + 1);
    // At flat angles the boundary may begin so far off that the image is beyond the domain, where nothing turns it any more.
    vec3 inDomain = clamp(reflected.x, domain.min, domain.max);
    reflections[rayIndex].list[waiting] = Reflection(inDomain, throughput.s, reflected.w, throughput.p,
                                                     transmittanceOfReturn() * tintOfMirror(),
                                                     packHalf2x16(vec2(float(ray.generation + 1u), spread)));
    reflections[rayIndex].waiting = waiting + 1u;
    return true;
}

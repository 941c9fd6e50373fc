// Reflections that are followed (docs/physics.md, section 4). Where a boundary ends, what it mirrors is noted and waits until
// the ray has come to its end (viewer/reflect.comp.glsl).
#include "physics/step_leapfrog.glsl"
#include "physics/mirror.glsl"
#include "shared/reflection_blocks.h"

layout(std430, binding = kStorageReflections) buffer Reflections { PixelReflections reflections[]; };

// The boundary under way where it is steepest so far.
struct Steepest {
    Ray ray;
    vec3 transmittance;
};
Steepest steepest;

void loadSteepest() {
    steepest.ray = Ray(reflections[rayIndex].steepestX, reflections[rayIndex].steepestW);
    steepest.transmittance = reflections[rayIndex].steepestTransmittance;
}

// Of a sample at x with wave vector w.
void noteSteepest(vec3 x, vec3 w, RayState ray) {
    steepest = Steepest(Ray(x, w), ray.transmittance);
}

void storeSteepest() {
    reflections[rayIndex].steepestX = steepest.ray.x;
    reflections[rayIndex].steepestW = steepest.ray.w;
    reflections[rayIndex].steepestTransmittance = steepest.transmittance;
}

#ifdef EFFECT_ROUGHNESS
#include "viewer/rough_boundary.glsl"
#endif

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

// The reflected ray on the mirror that `met` has reached.
Ray rayFromMirror(Ray met, vec3 away) {
    vec3 gradN = sampleOptics(met.x).gradN;
#ifdef EFFECT_ROUGHNESS
    if (surfaceAt(steepest.ray.x).a > 0.0) {
        return rayLeaving(met, away, gradN);
    }
#endif
    return rayMirrored(met, gradN);
}

// Lets the reflection at a boundary that ends at index nEnd wait, if it is worth it and there is room. Whether it does.
bool letWait(inout RayState ray, float nStart, float nEnd, vec3 away, Polarised throughput) {
    uint waiting = reflections[rayIndex].waiting;
    if (waiting >= uint(kMostWaiting) || !isWorthFollowing(ray, throughput)) {
        return false;
    }
    Ray met = rayAtIndex(steepest.ray, 0.5 * (nStart + nEnd), usualStepAt(steepest.ray.x));
    Ray reflected = rayFromMirror(met, away);
    ray.evaluations += uint(2 * kMirrorCorrections + 1);
    reflections[rayIndex].list[waiting] = Reflection(reflected.x, throughput.s, reflected.w, throughput.p,
                                                     steepest.transmittance * tintOfMirror(), ray.generation + 1u);
    reflections[rayIndex].waiting = waiting + 1u;
    return true;
}

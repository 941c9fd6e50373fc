// Fresnel terms of the boundaries that a viewing ray crosses: transmittance, and what the boundary mirrors.
#include "physics/fresnel.glsl"
#include "physics/boundary.glsl"
#include "viewer/background.glsl"

#ifdef EFFECT_REFLECTION

Crossing crossingOf(RayState ray, float nBefore) {
    return Crossing(ray.crossingNormal, ray.crossingGradMax, ray.crossingStart, nBefore, ray.crossingWTangential,
                    ray.crossingSide);
}

bool inBoundary(vec3 x) {
    return inInterface(x);
}

// Whether a sample ends the crossing that is under way.
bool boundaryEnds(RayState ray, bool inBand, Optics optics) {
    return crossingEnds(crossingOf(ray, ray.n), inBand, optics.gradN);
}

// The mirrored environment is looked up along the reflected ray's first direction: later bends of it are not followed.
void reflectAndTransmit(inout RayState ray, Crossing crossing, vec3 w, float nEnd) {
    Polarised transmittance = crossingTransmittance(crossing, w, nEnd);
    float weight =
        0.5 * (ray.throughputS * (1.0 - transmittance.s) + ray.throughputP * (1.0 - transmittance.p));
    vec3 reflected = crossingReflected(crossing, w);
    if (weight > 0.0 && dot(reflected, reflected) > 0.0) {
        ray.radiance += ray.transmittance * weight * background(normalize(reflected));
    }
    ray.throughputS *= transmittance.s;
    ray.throughputP *= transmittance.p;
}

// After a sample with wave vector w that ends no crossing; nBefore: index of the sample before.
void followBoundary(inout RayState ray, float nBefore, bool inBand, vec3 w, Optics optics) {
    Crossing next = crossingAfter(crossingOf(ray, nBefore), inBand, w, optics.n, optics.gradN);
    ray.crossingNormal = next.normal;
    ray.crossingGradMax = next.gradMax;
    ray.crossingStart = next.nStart;
    ray.crossingWTangential = next.wTangential;
    ray.crossingSide = next.sideAtStart;
}

// The same after any sample: light is split where it ends a crossing.
void endBoundary(inout RayState ray, float nBefore, bool inBand, vec3 w, Optics optics) {
    Crossing crossing = crossingOf(ray, nBefore);
    if (boundaryEnds(ray, inBand, optics)) {
        reflectAndTransmit(ray, crossing, w, crossingEndIndex(crossing, inBand, optics.n));
    }
    followBoundary(ray, nBefore, inBand, w, optics);
}

#else

bool inBoundary(vec3 x) {
    return false;
}

bool boundaryEnds(RayState ray, bool inBand, Optics optics) {
    return false;
}

void followBoundary(inout RayState ray, float nBefore, bool inBand, vec3 w, Optics optics) {}
void endBoundary(inout RayState ray, float nBefore, bool inBand, vec3 w, Optics optics) {}

#endif

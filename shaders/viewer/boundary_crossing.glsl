// Fresnel terms of the boundaries that a viewing ray crosses: transmittance, and what the boundary mirrors.
#include "physics/fresnel.glsl"
#include "physics/boundary.glsl"
#include "viewer/background.glsl"

#ifdef EFFECT_REFLECTION

Crossing crossingOf(RayState ray) {
    return Crossing(ray.crossingNormal, ray.crossingGradMax, ray.crossingStart, ray.n, ray.crossingWTangential,
                    ray.crossingSide);
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

// After a sample with wave vector w; ray.n is still the index of the sample before.
void followBoundary(inout RayState ray, vec3 w, Optics optics) {
    bool inBand = inInterface(ray.x);
    if (!inBand && ray.crossingGradMax == 0.0) {
        return;
    }
    Crossing crossing = crossingOf(ray);
    if (crossingEnds(crossing, inBand, optics.gradN)) {
        reflectAndTransmit(ray, crossing, w, crossingEndIndex(crossing, inBand, optics.n));
    }
    Crossing next = crossingAfter(crossing, inBand, w, optics.n, optics.gradN);
    ray.crossingNormal = next.normal;
    ray.crossingGradMax = next.gradMax;
    ray.crossingStart = next.nStart;
    ray.crossingWTangential = next.wTangential;
    ray.crossingSide = next.sideAtStart;
}

#else

void followBoundary(inout RayState ray, vec3 w, Optics optics) {}

#endif

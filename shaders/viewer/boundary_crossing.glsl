// Fresnel terms of the boundaries that a viewing ray crosses: transmittance, and what the boundary mirrors.
#include "viewer/ray_crossing.glsl"
#include "viewer/background.glsl"

#if defined(EFFECT_REFLECTION) && defined(FOLLOW_REFLECTIONS)
#include "viewer/reflection.glsl"
#else
void loadBoundary() {}
void storeBoundary() {}
void noteStart(vec3 x, vec3 w, RayState ray) {}
void noteSteepest(vec3 x, vec3 w, RayState ray) {}

BoundarySplit splitAt(Crossing crossing, vec3 w, float nEnd) {
    return crossingSplit(crossing, w, nEnd);
}

vec3 tintOfMirror() {
    return vec3(1.0);
}

bool letWait(inout RayState ray, float nStart, float nEnd, vec3 away, Polarised throughput, float spread) {
    return false;
}

float raySpread() {
    return 0.0;
}

void spreadRay(float more) {}
#endif

#ifdef EFFECT_REFLECTION

bool inBoundary(vec3 x) {
    return inInterface(x);
}

// Whether a sample ends the crossing that is under way.
bool boundaryEnds(RayState ray, bool inBand, Optics optics) {
    return crossingEnds(crossingOf(ray, ray.n), inBand, optics.gradN);
}

// The environment that a boundary mirrors, looked up along the reflected ray's first direction: later bends of it are not
// followed.
void mirrorEnvironment(inout RayState ray, vec3 away, Polarised throughput, float spread) {
    if (dot(away, away) > 0.0) {
        ray.radiance += ray.transmittance * tintOfMirror() * (0.5 * (throughput.s + throughput.p)) *
                        background(normalize(away), spread);
    }
}

void reflectAndTransmit(inout RayState ray, Crossing crossing, vec3 w, float nEnd) {
    BoundarySplit split = splitAt(crossing, w, nEnd);
    Polarised reflected = Polarised(ray.throughputS * split.reflected.s, ray.throughputP * split.reflected.p);
    bool reflects = reflected.s + reflected.p > 0.0;
    float spread = raySpread() + split.awaySpread;
    if (reflects && !letWait(ray, crossing.nStart, nEnd, split.away, reflected, spread)) {
        mirrorEnvironment(ray, split.away, reflected, spread);
    }
    spreadRay(split.onwardSpread);
    ray.throughputS *= split.transmitted.s;
    ray.throughputP *= split.transmitted.p;
#ifdef EFFECT_ROUGHNESS
    // Facets turn the ray where the boundary ends; elsewhere the field has turned it by itself.
    ray.w = split.onward == w ? ray.w : split.onward;
#endif
}

// After a step whose sample ends no crossing.
void followBoundary(inout RayState ray, Step taken) {
    Crossing next = crossingAfter(crossingOf(ray, taken.nBefore), taken.inBand, taken.w, taken.optics.n, taken.optics.gradN);
    if (next.gradMax != ray.crossingGradMax) {
        noteSteepest(taken.middle, taken.w, ray);
    }
    if (next.gradMax > 0.0 && ray.crossingGradMax == 0.0) {
        noteStart(taken.start, taken.wStart, ray);
    }
    setCrossing(ray, next);
}

// The same after any step: light is split where its sample ends a crossing.
void endBoundary(inout RayState ray, Step taken) {
    Crossing crossing = crossingOf(ray, taken.nBefore);
    if (crossingEnds(crossing, taken.inBand, taken.optics.gradN)) {
        reflectAndTransmit(ray, crossing, taken.w, crossingEndIndex(crossing, taken.inBand, taken.optics.n));
        setCrossing(ray, crossingNone(taken.nBefore));
    }
    followBoundary(ray, taken);
}

#else

bool inBoundary(vec3 x) {
    return false;
}

bool boundaryEnds(RayState ray, bool inBand, Optics optics) {
    return false;
}

void followBoundary(inout RayState ray, Step taken) {}
void endBoundary(inout RayState ray, Step taken) {}

#endif

// Boundaries of facets (docs/physics.md, section 4): a sample of a pixel takes one of those that its ray sees.
#include "physics/microfacet.glsl"

// Bits mixed: M. Jarzynski, M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
uvec3 pcg3d(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    return v + v.yzx * v.zxy;
}

// For the pixel's next facet, by rounds a sequence of low discrepancy that starts anywhere, independent of those of the pixel and
// the lens (viewer/sampling.cpp).
vec2 nextUniform() {
    uint facet = reflections[rayIndex].facets;
    reflections[rayIndex].facets = facet + 1u;
    uvec2 start = pcg3d(uvec3(uvec2(view.tileOrigin + tilePixel(rayIndex)), facet)).xy >> 8u;
    const vec2 kStep = vec2(0.2360679774997897, 0.6457513110645906);  // of the roots of 5 and 7
    return fract(vec2(start) / 16777216.0 + fract(float(view.roundIndex) * kStep));
}

// The ray goes on as much off its way as a facet turns it more than a plane does: over small edges and in a boundary's tail, where
// there is no plane, the field has turned it otherwise.
BoundarySplit roughSplit(Crossing crossing, vec3 w, float nEnd, float roughness) {
    vec2 uniform01 = nextUniform();
    vec3 against = -crossing.sideAtStart * crossingNormal(crossing);
    vec3 incident = crossingIncident(crossing, w);
    BoundarySplit split = splitAtFacet(incident, against, crossing.nStart, nEnd, alphaOfRoughness(roughness), uniform01.x,
                                       uniform01.y, view.sampleShare);
    split.onward = length(w) * normalize(w + split.onward - refractedWave(incident, against, nEnd));
    return split;
}

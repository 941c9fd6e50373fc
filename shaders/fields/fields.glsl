// The optical constants of the scene at a world position. Only what an effect asks for has a texture.
#include "fields/trilinear.glsl"
#include "physics/dispersion.glsl"
#include "shared/domain_block.h"

// A grid on the domain's lattice at a world position.
vec4 sampleGrid(sampler3D grid, vec3 x) {
    return sampleTrilinear(grid, (x - domainMin) * domainScale);
}

struct Optics {
    float n;
    vec3 gradN;  // [1 / scene unit]
};

#ifdef EFFECT_REFRACTION
layout(binding = kUnitOptics) uniform sampler3D opticsGrid;

// grad n in rgb [1 / scene unit], n in alpha.
#ifdef CUBIC_INTERPOLATION
#include "fields/spline.glsl"

// Positions beyond the outermost voxels' centres count as on them, as with a clamped texture.
vec4 fetchOptics(vec3 x) {
    vec3 last = vec3(domainSize - 1);
    vec3 place = clamp((x - domainMin) / domainVoxel - 0.5, vec3(0.0), last);
    vec3 first = min(floor(place), max(last - 1.0, vec3(0.0)));
    vec4 spline = sampleSpline(opticsGrid, ivec3(first), place - first);
    return vec4(spline.rgb / domainVoxel, spline.a);
}
#else
vec4 fetchOptics(vec3 x) {
    return sampleGrid(opticsGrid, x);
}
#endif
#endif

#if defined(EFFECT_DISPERSION)
// Whether this invocation has been where the index depends on the wavelength.
bool hasMetDispersion = false;

// grad B in rgb, Cauchy's B in alpha. Where B is in proportion to n - 1 everywhere, as with one glass in air, it needs no
// texture: domainDispersion has the factor.
#ifdef DISPERSION_BY_REFRACTIVITY
vec4 sampleCauchy(vec3 x, vec4 optics) {
    return vec4(optics.rgb, optics.a - 1.0);
}
#else
layout(binding = kUnitDispersion) uniform sampler3D dispersionGrid;

vec4 sampleCauchy(vec3 x, vec4 optics) {
    return sampleGrid(dispersionGrid, x);
}
#endif

// At the wavelength of the dispatch.
Optics sampleOptics(vec3 x) {
    vec4 texel = fetchOptics(x);
    vec4 cauchy = sampleCauchy(x, texel);
    hasMetDispersion = hasMetDispersion || cauchy != vec4(0.0);
    return Optics(dispersedIndex(texel.a, cauchy.a, domainDispersion),
                  dispersedGradient(texel.rgb, cauchy.rgb, domainDispersion));
}
#elif defined(EFFECT_REFRACTION)
Optics sampleOptics(vec3 x) {
    vec4 texel = fetchOptics(x);
    return Optics(texel.a, texel.rgb);
}
#else
Optics sampleOptics(vec3 x) {
    return Optics(domainIor, vec3(0.0));
}
#endif

#ifdef EFFECT_REFLECTION
layout(binding = kUnitInterface) uniform sampler3D interfaceGrid;

// Whether the voxel that x lies in belongs to the band of a boundary.
bool inInterface(vec3 x) {
    ivec3 index = ivec3(floor((x - domainMin) / domainVoxel));
    return texelFetch(interfaceGrid, clamp(index, ivec3(0), domainSize - 1), 0).r > 0.5;
}
#endif

#ifdef EFFECT_ABSORPTION
layout(binding = kUnitSigmaA) uniform sampler3D sigmaAGrid;

// Absorption [1 / scene unit].
vec3 sampleSigmaA(vec3 x) {
    return sampleGrid(sigmaAGrid, x).rgb;
}
#endif

#ifdef EFFECT_SCATTERING
layout(binding = kUnitSigmaS) uniform sampler3D sigmaSGrid;

// Scattering in rgb [1 / scene unit], Henyey-Greenstein g in alpha.
vec4 sampleSigmaS(vec3 x) {
    return sampleGrid(sigmaSGrid, x);
}
#endif

#ifdef EFFECT_EMISSION
layout(binding = kUnitEmission) uniform sampler3D emissionGrid;

// Radiance per scene unit.
vec3 sampleEmission(vec3 x) {
    return sampleGrid(emissionGrid, x).rgb;
}
#endif

#ifdef EFFECT_OPAQUE
layout(binding = kUnitOpaque) uniform sampler3D opaqueGrid;

// Albedo in rgb, coverage by opaque matter in alpha.
vec4 sampleOpaque(vec3 x) {
    return sampleGrid(opaqueGrid, x);
}
#endif

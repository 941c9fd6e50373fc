// The optical constants of the scene at a world position. Only what an effect asks for has a texture.
#include "fields/trilinear.glsl"
#include "physics/depth.glsl"
#include "physics/dispersion.glsl"
#include "shared/brick.h"
#include "shared/domain_block.h"

// Texture coordinate of a world position in grids on the domain's lattice, and back.
vec3 coordinateOf(vec3 x) {
    return (x - domain.min) * domain.scale;
}

vec3 placeOf(vec3 coordinate) {
    return domain.min + coordinate / domain.scale;
}

// A grid on the domain's lattice at a world position.
vec4 sampleGrid(sampler3D grid, vec3 x) {
    return sampleTrilinear(grid, coordinateOf(x));
}

struct Optics {
    float n;
    vec3 gradN;  // [1 / scene unit]
};

#ifdef INSETS
#include "fields/insets.glsl"
#else

// What objects with lattices of their own put over the domain's grids: none has one.
float finestVoxelAbout(vec3 x) {
    return 1.0;
}

#define overDomain(x, below, quantity) (below)
#define bandOverDomain(x, below) (below)
#define surfaceOverDomain(x, below) (below)
#define matterOverDomain(x, below, quantity) (below)
#define scatteringOverDomain(x, below) (below)
#define anisotropyOverDomain(x, below, scattering) (below)
#define opaqueOverDomain(x, below) (below)
#endif

// Edge of the finest voxel about x [scene units].
float voxelAt(vec3 x) {
    return domain.voxel * finestVoxelAbout(x);
}

// The voxel of a grid on the domain's lattice that x lies in. A grid that only objects with lattices of their own call for has
// one voxel.
ivec3 voxelAbout(vec3 x, sampler3D grid) {
#ifdef INSETS
    ivec3 size = textureSize(grid, 0);
#else
    ivec3 size = domain.size;
#endif
    return clamp(ivec3(floor((x - domain.min) / domain.voxel)), ivec3(0), size - 1);
}

#ifdef EFFECT_REFRACTION
layout(binding = kUnitOptics) uniform sampler3D opticsGrid;

// At a texture coordinate: grad n in rgb [1 / scene unit], n in alpha.
#ifdef CUBIC_INTERPOLATION
#include "fields/spline.glsl"

// Positions beyond the outermost voxels' centres count as on them, as with a clamped texture.
vec4 fetchOptics(vec3 coordinate) {
    vec3 last = vec3(domain.size - 1);
    vec3 place = clamp(coordinate * vec3(domain.size) - 0.5, vec3(0.0), last);
    vec3 first = min(floor(place), max(last - 1.0, vec3(0.0)));
    vec4 spline = sampleSpline(opticsGrid, ivec3(first), place - first);
    return vec4(spline.rgb / domain.voxel, spline.a);
}
#else
vec4 fetchOptics(vec3 coordinate) {
    return sampleTrilinear(opticsGrid, coordinate);
}
#endif
#endif

#if defined(EFFECT_DISPERSION)
// Whether this invocation has been where the index depends on the wavelength.
bool hasMetDispersion = false;

// grad B in rgb, Cauchy's B in alpha. Where B is in proportion to n - 1 everywhere, as with one glass in air, it needs no
// texture: domain.dispersion has the factor.
#ifdef DISPERSION_BY_REFRACTIVITY
vec4 fetchCauchy(vec3 coordinate, vec4 optics) {
    return vec4(optics.rgb, optics.a - 1.0);
}
#else
layout(binding = kUnitDispersion) uniform sampler3D dispersionGrid;

vec4 fetchCauchy(vec3 coordinate, vec4 optics) {
    return sampleTrilinear(dispersionGrid, coordinate);
}
#endif

// At the wavelength of the dispatch.
Optics opticsOf(vec4 texel, vec4 cauchy) {
    hasMetDispersion = hasMetDispersion || cauchy != vec4(0.0);
    return Optics(dispersedIndex(texel.a, cauchy.a, domain.dispersion),
                  dispersedGradient(texel.rgb, cauchy.rgb, domain.dispersion));
}

Optics sampleOptics(vec3 x) {
    vec4 below = fetchOptics(coordinateOf(x));
    vec4 cauchy = fetchCauchy(coordinateOf(x), below);
    return opticsOf(overDomain(x, below, kInsetIndex), overDomain(x, cauchy, kInsetDispersion));
}

// Of the domain's own grids alone, at a texture coordinate.
Optics domainOptics(vec3 coordinate) {
    vec4 texel = fetchOptics(coordinate);
    return opticsOf(texel, fetchCauchy(coordinate, texel));
}
#elif defined(EFFECT_REFRACTION)
Optics sampleOptics(vec3 x) {
    vec4 texel = overDomain(x, fetchOptics(coordinateOf(x)), kInsetIndex);
    return Optics(texel.a, texel.rgb);
}

// Of the domain's own grid alone, at a texture coordinate.
Optics domainOptics(vec3 coordinate) {
    vec4 texel = fetchOptics(coordinate);
    return Optics(texel.a, texel.rgb);
}
#else
Optics sampleOptics(vec3 x) {
    return Optics(domain.ior, vec3(0.0));
}
#endif

#ifdef EFFECT_REFLECTION
layout(binding = kUnitInterface) uniform sampler3D interfaceGrid;

// Whether the voxel that x lies in belongs to the band of a boundary.
bool inInterface(vec3 x) {
    return bandOverDomain(x, texelFetch(interfaceGrid, voxelAbout(x, interfaceGrid), 0).r > 0.5);
}
#endif

#if defined(EFFECT_TINT) || defined(EFFECT_ROUGHNESS)
layout(binding = kUnitSurface) uniform sampler3D surfaceGrid;

// Of a boundary in the voxel that x lies in: factor on what it reflects in rgb, roughness in alpha.
vec4 surfaceAt(vec3 x) {
    return surfaceOverDomain(x, texelFetch(surfaceGrid, voxelAbout(x, surfaceGrid), 0));
}
#endif

#ifdef EFFECT_ABSORPTION
layout(binding = kUnitSigmaA) uniform sampler3D sigmaAGrid;

// Absorption [1 / scene unit].
vec3 sampleSigmaA(vec3 x) {
    return matterOverDomain(x, sampleGrid(sigmaAGrid, x).rgb, kInsetAbsorption);
}
#endif

#ifdef EFFECT_SCATTERING
layout(binding = kUnitSigmaS) uniform sampler3D sigmaSGrid;

// Scattering in rgb [1 / scene unit], Henyey-Greenstein g in alpha.
vec4 sampleSigmaS(vec3 x) {
    return scatteringOverDomain(x, sampleGrid(sigmaSGrid, x));
}

// Henyey-Greenstein g: of each band, or of all.
#ifdef ANISOTROPY_BY_BAND
layout(binding = kUnitAnisotropy) uniform sampler3D anisotropyGrid;

vec3 sampleAnisotropy(vec3 x, vec4 sigmaS) {
    return anisotropyOverDomain(x, sampleGrid(anisotropyGrid, x).rgb, sampleGrid(sigmaSGrid, x).rgb);
}
#else
float sampleAnisotropy(vec3 x, vec4 sigmaS) {
    return sigmaS.a;
}
#endif
#endif

#ifdef EFFECT_EMISSION
layout(binding = kUnitEmission) uniform sampler3D emissionGrid;

// Radiance per scene unit.
vec3 sampleEmission(vec3 x) {
    return matterOverDomain(x, sampleGrid(emissionGrid, x).rgb, kInsetEmission);
}
#endif

#ifdef EFFECT_OPAQUE
layout(binding = kUnitOpaque) uniform sampler3D opaqueGrid;

// Albedo in rgb, depth in opaque matter in alpha.
vec4 sampleOpaque(vec3 x) {
    return opaqueOverDomain(x, sampleGrid(opaqueGrid, x));
}
#endif

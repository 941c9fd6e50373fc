// The sums that light is deposited into: power x path length in voxels by band, and the same times the direction of travel.
// With LIGHT_LOBES: the same by bins of direction, in listed voxels.
#include "lightsim/settings.glsl"
#include "lightsim/fixed_point.glsl"
#include "shared/domain_block.h"

bool isInSlab(ivec3 voxel) {
    return voxel.z >= settings.slabBegin && voxel.z < settings.slabEnd;
}

uint slabIndex(ivec3 voxel) {
    return (uint(voxel.z - settings.slabBegin) * uint(domain.size.y) + uint(voxel.y)) * uint(domain.size.x) + uint(voxel.x);
}

#ifdef LIGHT_LOBES
#include "lightsim/lobe_bins.glsl"
#else

layout(std430, binding = BAKE_FLUX_BINDING) buffer FluxX { uvec2 fluxX[]; };
layout(std430, binding = BAKE_FLUX_BINDING + 1) buffer FluxY { uvec2 fluxY[]; };
layout(std430, binding = BAKE_FLUX_BINDING + 2) buffer FluxZ { uvec2 fluxZ[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING) buffer Irradiance0 { uvec2 irradiance0[]; };
#if BANDS == 3
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 1) buffer Irradiance1 { uvec2 irradiance1[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 2) buffer Irradiance2 { uvec2 irradiance2[]; };
#endif

// Whether what is added at a voxel of the domain goes anywhere.
bool takesLight(ivec3 voxel) {
    return isInSlab(voxel);
}

// Adds a part of what a voxel gets: fixed-point units of power x length, and of flux x length.
void addAt(ivec3 voxel, vec3 powerLength, vec3 flux) {
    if (!takesLight(voxel)) {
        return;
    }
    uint index = slabIndex(voxel);
    ADD_FIXED(fluxX, index, fixedPoint(flux.x))
    ADD_FIXED(fluxY, index, fixedPoint(flux.y))
    ADD_FIXED(fluxZ, index, fixedPoint(flux.z))
    ADD_FIXED(irradiance0, index, fixedPoint(powerLength.x))
#if BANDS == 3
    ADD_FIXED(irradiance1, index, fixedPoint(powerLength.y))
    ADD_FIXED(irradiance2, index, fixedPoint(powerLength.z))
#endif
}
#endif

// Of the strongest band.
float brightestOf(vec3 powerLength) {
#if BANDS == 3
    return max(powerLength.x, max(powerLength.y, powerLength.z));
#else
    return powerLength.x;
#endif
}

// The sum over bands, along a direction.
vec3 fluxOf(vec3 powerLength, vec3 travel) {
#if BANDS == 3
    return travel * (powerLength.x + powerLength.y + powerLength.z);
#else
    return travel * powerLength.x;
#endif
}

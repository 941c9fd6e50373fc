#pragma once
// Where the lattice of the fields lies. std140: each vec3 is followed by the scalar that fills its row.

#include "shaders/shared/bindings.h"

#ifdef __cplusplus
#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::gpu {

using glm::ivec3;
using glm::vec3;

struct DomainBlock {
#else
layout(std140, binding = kUniformDomain) uniform DomainBlock {
#endif
    vec3 domainMin;      // lower corner of the box [scene units]
    float domainVoxel;   // edge of a voxel [scene units]
    vec3 domainMax;      // upper corner [scene units]
    float domainIor;     // index where the scene has no index field
    vec3 domainScale;    // texture coordinate per scene unit, by axis
    float domainDispersion;  // 1/wavelength^2 - 1/wavelength_d^2, times the unit of B in the fields (fields/fields.glsl)
    ivec3 domainSize;    // voxels
    int domainPad1;
};

#ifdef __cplusplus
static_assert(offsetof(DomainBlock, domainVoxel) == 12);
static_assert(offsetof(DomainBlock, domainMax) == 16);
static_assert(offsetof(DomainBlock, domainIor) == 28);
static_assert(offsetof(DomainBlock, domainScale) == 32);
static_assert(offsetof(DomainBlock, domainSize) == 48);
static_assert(sizeof(DomainBlock) == 64);

} // namespace eikonal::gpu
#endif

#pragma once
// Where the lattice of the fields lies. std140: each vec3 is followed by the scalar that fills its row.

#include "shaders/shared/bindings.h"

#ifdef __cplusplus
#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::gpu {

using glm::ivec3;
using glm::vec3;
#endif

struct DomainBlock {
    vec3 min;          // lower corner of the box [scene units]
    float voxel;       // edge of a voxel [scene units]
    vec3 max;          // upper corner [scene units]
    float ior;         // index where the scene has no index field
    vec3 scale;        // texture coordinate per scene unit, by axis
    float dispersion;  // 1/wavelength^2 - 1/wavelength_d^2, times the unit of B in the fields (fields/fields.glsl)
    ivec3 size;        // voxels
    int pad;
};

#ifdef __cplusplus
static_assert(offsetof(DomainBlock, voxel) == 12);
static_assert(offsetof(DomainBlock, max) == 16);
static_assert(offsetof(DomainBlock, ior) == 28);
static_assert(offsetof(DomainBlock, scale) == 32);
static_assert(offsetof(DomainBlock, size) == 48);
static_assert(sizeof(DomainBlock) == 64);

} // namespace eikonal::gpu
#else
layout(std140, binding = kUniformDomain) uniform Domain { DomainBlock domainGiven; };

// Read once, member by member: the software renderer gathers a uniform anew, lane by lane, wherever it is named, and a copy of
// the whole is no more to it than another name.
DomainBlock domain = DomainBlock(
    domainGiven.min, domainGiven.voxel, domainGiven.max, domainGiven.ior, domainGiven.scale, domainGiven.dispersion,
    domainGiven.size, domainGiven.pad);
#endif

#pragma once
// Objects with lattices of their own (common/insets.h) as kernels find them (shaders/fields/insets.glsl).

#include "shaders/shared/bindings.h"

#ifdef __cplusplus
#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::gpu {

using glm::ivec3;
using glm::ivec4;
using glm::vec3;
using glm::vec4;
#endif

const int kUniformInsets = 3;
const int kStorageInsetBricks = 3;  // two words a brick of the domain: bits of the insets about it; their finest voxel over
                                    // the domain's, a float that is 1 at most. Kernels with a display have no fields

const int kMostInsets = 32;  // a bit each

// Quantities of an inset: four numbers at each of its voxels, or the same four everywhere.
const int kInsetCoverage = 0;    // grad c in rgb [1 / voxel of the inset], the smoothed coverage c in alpha
const int kInsetIndex = 1;       // the same of c n; everywhere: n
const int kInsetDispersion = 2;  // the same of c B; everywhere: B [micrometres^2]
const int kInsetAbsorption = 3;  // area coverage times absorption [1 / scene unit] in rgb; everywhere: the absorption
const int kInsetScattering = 4;  // the same of scattering, Henyey-Greenstein g in alpha
const int kInsetEmission = 5;    // the same of emission
const int kInsetOpaque = 6;      // albedo in rgb, coverage by opaque matter in alpha; everywhere: its share of the area coverage
const int kInsetSurface = 7;     // everywhere: factor on what its boundary reflects in rgb, roughness in alpha
const int kInsetQuantities = 8;

struct InsetBlock {
    vec4 placeFromDevice[3];  // rows of the map to the inset's lattice [its voxels from its lower corner]
    ivec3 size;               // voxels
    int displaces;            // 1: its matter takes the place of what it lies over; 0: it is opaque, and has none
    ivec3 extentFirst;        // first texel in the atlas of extents
    int insetPad;
    ivec4 first[kInsetQuantities];    // first texel in the atlas of values; w: 1, or 0 where the quantity is `everywhere`
    vec4 everywhere[kInsetQuantities];
};

#ifdef __cplusplus
struct InsetsBlock {
#else
layout(std140, binding = kUniformInsets) uniform InsetsBlock {
#endif
    vec3 insetValueScale;   // texture coordinate per texel of the atlas of values
    int insetCount;
    vec3 insetExtentScale;  // the same of extents
    int insetsPad;
    InsetBlock insets[kMostInsets];
};

#ifdef __cplusplus
static_assert(offsetof(InsetBlock, size) == 48 && offsetof(InsetBlock, extentFirst) == 64);
static_assert(offsetof(InsetBlock, first) == 80 && offsetof(InsetBlock, everywhere) == 208 && sizeof(InsetBlock) == 336);
static_assert(offsetof(InsetsBlock, insets) == 32 && sizeof(InsetsBlock) == 32 + kMostInsets * sizeof(InsetBlock));

} // namespace eikonal::gpu
#endif

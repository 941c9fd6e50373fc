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

// Two words a brick of the domain: bits of the insets about it; their finest voxel over the domain's, a float that is 1 at most.
const int kInsetBricksPerRow = 2;
const int kMostInsets = 32;  // a bit each

// Quantities of an inset: four numbers at each of its voxels, or the same four everywhere.
const int kInsetCoverage = 0;    // grad c in rgb [1 / voxel of the inset], the smoothed coverage c in alpha
const int kInsetIndex = 1;       // the same of c n; everywhere: n
const int kInsetDispersion = 2;  // the same of c B; everywhere: B [micrometres^2]
const int kInsetAbsorption = 3;  // area coverage times absorption [1 / scene unit] in rgb; everywhere: the absorption
const int kInsetScattering = 4;  // the same of scattering, Henyey-Greenstein g in alpha
const int kInsetEmission = 5;    // the same of emission
const int kInsetOpaque = 6;      // albedo in rgb, depth in opaque matter in alpha; everywhere: the albedo
const int kInsetSurface = 7;     // everywhere: factor on what its boundary reflects in rgb, roughness in alpha
const int kInsetAnisotropy = 8;  // g of each band in rgb, whatever the coverage; everywhere: 1 in alpha where bands differ
const int kInsetQuantities = 9;

// Rows of four words, read as texels.
const int kInsetPlaceRow = 0;
const int kInsetSizeRow = 3;
const int kInsetExtentRow = 4;
const int kFirstInsetBoxRow = 5;
const int kFirstInsetValueRow = kFirstInsetBoxRow + kInsetQuantities;
const int kRowsPerInset = kFirstInsetValueRow + kInsetQuantities;

#ifdef __cplusplus
struct InsetRows {
    vec4 placeFromDevice[3];  // rows of the map to the inset's lattice [its voxels from its lower corner]
    ivec3 size;               // voxels
    int displaces;            // 1: its matter takes the place of what it lies over; 0: it is opaque, and has none
    ivec3 extentFirst;        // first texel in the atlas of extents
    int pad;
    ivec4 first[kInsetQuantities];    // first texel in the atlas of values; w: 1, or 0 where the quantity is `everywhere`
    vec4 everywhere[kInsetQuantities];
};

static_assert(offsetof(InsetRows, placeFromDevice) == 16 * kInsetPlaceRow && offsetof(InsetRows, size) == 16 * kInsetSizeRow);
static_assert(offsetof(InsetRows, displaces) == 16 * kInsetSizeRow + 12 &&
              offsetof(InsetRows, extentFirst) == 16 * kInsetExtentRow);
static_assert(offsetof(InsetRows, first) == 16 * kFirstInsetBoxRow && offsetof(InsetRows, everywhere) == 16 * kFirstInsetValueRow);
static_assert(sizeof(InsetRows) == 16 * kRowsPerInset);

struct InsetsBlock {
#else
layout(std140, binding = kUniformInsets) uniform InsetsBlock {
#endif
    vec3 insetValueScale;   // texture coordinate per texel of the atlas of values
    float insetPadA;
    vec3 insetExtentScale;  // the same of extents
    float insetPadB;
};

#ifdef __cplusplus
static_assert(sizeof(InsetsBlock) == 32);

} // namespace eikonal::gpu
#endif

// Cells as they are stored: in rows of four words, which are read as texels (see tracks.glsl). Corners 0 to 3 before, 4 to 7 after
// the steps, in the order (u0, v0), (u1, v0), (u0, v1), (u1, v1).
#include "shared/bindings.h"

layout(binding = kUnitTubeCells) uniform usamplerBuffer cellTexels;

// Of the corners: position from the domain's lower corner [voxels]; w of the later four: arc length between [voxels]; of the first
// two: optical path from the light before and after the steps [scene units]; of the third: about the cell's volume [voxels^3].
const int kFirstCornerRow = 0;
// Share of the launched power that is left at the corners: a row each, by band, or four corners in a row.
const int kFirstShareRow = 8;
#if BANDS == 3
const int kFirstMirrorRow = kFirstShareRow + 8;
#else
const int kFirstMirrorRow = kFirstShareRow + 2;
#endif
// Steps since the last mirror at the corners, negative before it, where rays are followed from mirrors on.
#ifdef FOLLOW_REFLECTIONS
const int kFirstVolumeRow = kFirstMirrorRow + 2;
#else
const int kFirstVolumeRow = kFirstMirrorRow;
#endif
// At the corners: root of the volume per u, v and t over the relative power there [voxels^(3/2)].
const int kPowerRow = kFirstVolumeRow + 2;
// Power launched into the sub-cell, by band; w: power x length that need not be split into more lines [x voxels].
const int kLitPartsRow = kPowerRow + 1;
// Of the steps at the corners: what lies in front of opaque matter.
#ifdef EFFECT_OPAQUE
const int kRowsPerCell = kLitPartsRow + 1;
#else
const int kRowsPerCell = kLitPartsRow;
#endif

int cellRowIndex(uint cell, int row) {
    return kRowsPerCell * int(cell) + row;
}

vec4 cellRow(uint cell, int row) {
    return uintBitsToFloat(texelFetch(cellTexels, cellRowIndex(cell, row)));
}

vec4 cornerOf(uint cell, int corner) {
    return cellRow(cell, kFirstCornerRow + corner);
}

float volumeOf(uint cell) {
    return cornerOf(cell, 2).w;
}

Trilinear mapOf(uint cell) {
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = cornerOf(cell, i).xyz;
    }
    return trilinearOf(x);
}

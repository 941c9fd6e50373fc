// Cells as they are read: TubeCell's members in their order, in rows of four words, as texels (see tracks.glsl).
#include "shared/bindings.h"

layout(binding = kUnitTubeCells) uniform usamplerBuffer cellTexels;

const int kRowsPerCell = 20;
const int kFirstShareRow = 8;
const int kFirstVolumeRow = 16;
const int kPowerRow = 18;
const int kLitPartsRow = 19;

vec4 cellRow(uint cell, int row) {
    return uintBitsToFloat(texelFetch(cellTexels, kRowsPerCell * int(cell) + row));
}

vec4 cornerOf(uint cell, int corner) {
    return cellRow(cell, corner);
}

vec4 shareOf(uint cell, int corner) {
    return cellRow(cell, kFirstShareRow + corner);
}

Trilinear mapOf(uint cell) {
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = cornerOf(cell, i).xyz;
    }
    return trilinearOf(x);
}

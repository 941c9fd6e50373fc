// Pixels of the film, read as texels and written row by row, as rays are (viewer/ray_states.glsl).
#include "shared/view_blocks.h"

// Rows of four words a pixel, FilmPixel's members in their order.
const int kRowsPerPixel = 5;
const int kRadianceRow = 0;    // radiance, halfLuminance: what every sample changes
const int kExitRow = 1;        // exitDirection, entryDistance
const int kDepthRow = 2;       // depth, opticalLength
const int kThroughputRow = 3;  // throughput, steps
const int kNormalRow = 4;      // normal

layout(binding = kUnitFilm) uniform usamplerBuffer filmTexels;

vec4 filmRow(usamplerBuffer film, uint pixel, int row) {
    return uintBitsToFloat(texelFetch(film, kRowsPerPixel * int(pixel) + row));
}

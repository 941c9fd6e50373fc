// The tracks of all vertices through the window: TUBE_SAMPLES samples each. What earlier kernels wrote of them is read as texels,
// which takes the software renderer a tenth of the time.
#include "shared/bindings.h"

layout(std430, binding = TUBE_POSITIONS_BINDING) writeonly buffer PositionBlock {
    vec4 positions[];  // world position; w: arc length of the step that ends there [scene units]
};

layout(std430, binding = TUBE_SHARES_BINDING) writeonly buffer ShareBlock {
    vec4 shares[];  // share of the launched power that is left there, by band
};

layout(binding = kUnitTubePositions) uniform usamplerBuffer positionTexels;
layout(binding = kUnitTubeShares) uniform usamplerBuffer shareTexels;

vec4 positionAt(uint place) {
    return uintBitsToFloat(texelFetch(positionTexels, int(place)));
}

vec4 shareAt(uint place) {
    return uintBitsToFloat(texelFetch(shareTexels, int(place)));
}

uint trackOf(uint vertex) {
    return vertex * uint(TUBE_SAMPLES);
}

// The bit of a sample in a mask of two words.
uvec2 sampleBit(int k) {
    return k < 32 ? uvec2(1u << uint(k), 0u) : uvec2(0u, 1u << uint(k - 32));
}

bool hasSample(uvec2 mask, int k) {
    return (k < 32 ? mask.x >> uint(k) : mask.y >> uint(k - 32)) % 2u == 1u;
}

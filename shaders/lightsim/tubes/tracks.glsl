// The tracks of all vertices through the window: TUBE_SAMPLES samples each. What earlier kernels wrote of them is read as texels,
// which takes the software renderer a tenth of the time.
#include "shared/bindings.h"

layout(std430, binding = TUBE_POSITIONS_BINDING) writeonly buffer PositionBlock {
    vec4 positions[];  // world position; w: arc length of the step that ends there [scene units]
};

// Share of the launched power that is left there, by band, and where rays are followed from mirrors on, the steps since the last.
#if BANDS == 3
#define SHARE_ROW vec4
#elif defined(FOLLOW_REFLECTIONS)
#define SHARE_ROW vec2
#else
#define SHARE_ROW float
#endif
layout(std430, binding = TUBE_SHARES_BINDING) writeonly buffer ShareBlock {
    SHARE_ROW shares[];
};

layout(binding = kUnitTubePositions) uniform usamplerBuffer positionTexels;
layout(binding = kUnitTubeShares) uniform usamplerBuffer shareTexels;

vec4 positionAt(uint place) {
    return uintBitsToFloat(texelFetch(positionTexels, int(place)));
}

// By band in rgb, the steps since the last mirror in alpha: negative before it.
vec4 shareAt(uint place) {
    vec4 row = uintBitsToFloat(texelFetch(shareTexels, int(place)));
#if BANDS == 3
    return row;
#elif defined(FOLLOW_REFLECTIONS)
    return vec4(row.rrr, row.g);
#else
    return vec4(row.rrr, 0.0);
#endif
}

void recordShare(uint place, vec4 share) {
#if BANDS == 3
    shares[place] = share;
#elif defined(FOLLOW_REFLECTIONS)
    shares[place] = share.ra;
#else
    shares[place] = share.r;
#endif
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

// The tracks of all vertices through the window: TUBE_SAMPLES samples each.

layout(std430, binding = TUBE_POSITIONS_BINDING) buffer PositionBlock {
    vec4 positions[];  // world position; w: arc length of the step that ends there [scene units]
};

layout(std430, binding = TUBE_SHARES_BINDING) buffer ShareBlock {
    vec4 shares[];  // share of the launched power that is left there, by band
};

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

// Sums in 64-bit two's complement fixed point, as two 32-bit words with carry: integer addition commutes, so the same
// contributions give the same bits in whatever order they arrive.

// The two words (low, high) of a value already scaled to fixed-point units, |value| < 2^47: by pieces, for conversions of floats
// beyond 2^31 to integers are not portable.
uvec2 fixedPoint(float value) {
    float rounded = floor(value + 0.5);
    float high = floor(rounded / 65536.0);
    int highWord = int(high);
    return uvec2(uint(highWord) << 16 | uint(int(rounded - high * 65536.0)), uint(highWord >> 16));
}

// The same for 0 <= value < 2^63.
uvec2 largeFixedPoint(float value) {
    float magnitude = floor(value + 0.5);
    float high = floor(magnitude / 4294967296.0);
    float rest = magnitude - high * 4294967296.0;
    float middle = floor(rest / 65536.0);
    return uvec2((uint(int(middle)) << 16) | uint(int(rest - middle * 65536.0)), uint(int(high)));
}

// Adds the words to the element `index` of a buffer of uvec2.
#define ADD_FIXED(sums, index, words)                                              \
    {                                                                              \
        uvec2 addend = (words);                                                    \
        uint before = atomicAdd(sums[index].x, addend.x);                          \
        uint carried = addend.y + (before + addend.x < before ? 1u : 0u);          \
        if (carried != 0u) {                                                       \
            atomicAdd(sums[index].y, carried);                                     \
        }                                                                          \
    }

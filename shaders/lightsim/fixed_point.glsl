// Sums in 64-bit two's complement fixed point, as two 32-bit words with carry: integer addition commutes, so the same
// contributions give the same bits in whatever order they arrive.

// The two words (low, high) of a value already scaled to fixed-point units, |value| < 2^31.
uvec2 fixedPoint(float value) {
    int rounded = int(floor(value + 0.5));
    return uvec2(uint(rounded), uint(rounded >> 31));
}

// The same for 0 <= value < 2^63, by pieces: conversions of floats beyond 2^31 to integers are not portable.
uvec2 largeFixedPoint(float value) {
    float magnitude = floor(value + 0.5);
    float high = floor(magnitude / 4294967296.0);
    float rest = magnitude - high * 4294967296.0;
    float middle = floor(rest / 65536.0);
    return uvec2((uint(int(middle)) << 16) | uint(int(rest - middle * 65536.0)), uint(int(high)));
}

// The same for |value| < 2^63.
uvec2 wideFixedPoint(float value) {
    if (abs(value) < 2147483000.0) {
        return fixedPoint(value);
    }
    uvec2 words = largeFixedPoint(abs(value));
    if (value < 0.0) {
        words = ~words + uvec2(1u, words.x == 0u ? 1u : 0u);
    }
    return words;
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

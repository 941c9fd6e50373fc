// Light of listed voxels by bins of direction, for their lobes (docs/physics.md, section 5).
// A voxel's total is known from the pass before. Its sums are shares of that, so that a word each is enough: they are
// integers, and the order of additions does not matter.

layout(std430, binding = BAKE_LOBE_ROWS_BINDING) readonly buffer LobeRows { uint rowAfter[]; };  // of a voxel: row + 1, or 0
layout(std430, binding = BAKE_LOBE_SCALES_BINDING) readonly buffer LobeScales { float rowScale[]; };  // units of a word per unit
layout(std430, binding = BAKE_LOBE_BINS_BINDING) buffer LobeBins { int lobeBins[]; };

// Bin of a direction of any length: the square of the octahedral map that it falls into.
uint lobeBinOf(vec3 direction) {
    vec3 onOctahedron = direction / max(abs(direction.x) + abs(direction.y) + abs(direction.z), 1.0e-30);
    vec2 folded = onOctahedron.xy;
    if (onOctahedron.z < 0.0) {
        vec2 signs = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(onOctahedron.xy, vec2(0.0)));
        folded = (1.0 - abs(onOctahedron.yx)) * signs;
    }
    ivec2 square = clamp(ivec2((folded * 0.5 + 0.5) * float(LOBE_BINS_ACROSS)), ivec2(0), ivec2(LOBE_BINS_ACROSS - 1));
    return uint(square.y * LOBE_BINS_ACROSS + square.x);
}

void addShare(uint word, float share) {
    atomicAdd(lobeBins[word], int(floor(share + 0.5)));
}

// Whether what is added at a voxel of the domain goes anywhere.
bool takesLight(ivec3 voxel) {
    return isInSlab(voxel) && rowAfter[slabIndex(voxel)] != 0u;
}

// Adds a part of what a voxel gets: units of power x length, and of flux x length.
void addAt(ivec3 voxel, vec3 powerLength, vec3 flux) {
    if (!takesLight(voxel)) {
        return;
    }
    uint row = rowAfter[slabIndex(voxel)] - 1u;
    uint first = (row * uint(LOBE_BINS) + lobeBinOf(flux)) * uint(LOBE_WORDS(BANDS));
    vec3 powerShare = powerLength * rowScale[row];
    vec3 fluxShare = flux * rowScale[row];
    addShare(first, powerShare.x);
#if BANDS == 3
    addShare(first + 1u, powerShare.y);
    addShare(first + 2u, powerShare.z);
#endif
    for (int axis = 0; axis < 3; ++axis) {
        addShare(first + uint(BANDS + axis), fluxShare[axis]);
    }
}

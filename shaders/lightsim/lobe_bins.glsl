// Light of listed voxels by bins of direction, for their lobes (docs/physics.md, section 5).
// A voxel's total is known from the pass before. Its sums are shares of that, so that a word each is enough: they are
// integers, and the order of additions does not matter.

layout(std430, binding = BAKE_LOBE_ROWS_BINDING) readonly buffer LobeRows { uint rowAfter[]; };  // of a voxel: row + 1, or 0
layout(std430, binding = BAKE_LOBE_SCALES_BINDING) readonly buffer LobeScales { float rowScale[]; };  // from units to words
layout(std430, binding = BAKE_LOBE_POWERS_BINDING) buffer LobePowers { int lobePowers[]; };  // BANDS words a bin
layout(std430, binding = BAKE_LOBE_FLUXES_BINDING) buffer LobeFluxes { int lobeFluxes[]; };  // three words a bin

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

int wordOf(float share) {
    return int(floor(share + 0.5));
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
    uint bin = row * uint(LOBE_BINS) + lobeBinOf(flux);
    // whole units, as the pass before has summed them up: what was too weak to count there does not count here
    vec3 counted = floor(powerLength + 0.5);
#if BANDS == 3
    float all = counted.x + counted.y + counted.z;
#else
    float all = counted.x;
#endif
    if (all == 0.0) {
        return;
    }
    vec3 powerShare = counted * rowScale[row];
    vec3 fluxShare = flux * rowScale[row];
    atomicAdd(lobePowers[uint(BANDS) * bin], wordOf(powerShare.x));
#if BANDS == 3
    atomicAdd(lobePowers[3u * bin + 1u], wordOf(powerShare.y));
    atomicAdd(lobePowers[3u * bin + 2u], wordOf(powerShare.z));
#endif
    atomicAdd(lobeFluxes[3u * bin], wordOf(fluxShare.x));
    atomicAdd(lobeFluxes[3u * bin + 1u], wordOf(fluxShare.y));
    atomicAdd(lobeFluxes[3u * bin + 2u], wordOf(fluxShare.z));
}

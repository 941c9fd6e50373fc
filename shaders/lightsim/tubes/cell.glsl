// A cell: the trilinear image of the unit cube that a sub-cell of a node sweeps in a step, in voxels.

// x(u, v, t) = c000 + c100 u + c010 v + c001 t + c110 u v + c101 u t + c011 v t + c111 u v t
struct Trilinear {
    vec3 c000, c100, c010, c001, c110, c101, c011, c111;
};

Trilinear trilinearOf(vec3 x[8]) {
    Trilinear map;
    map.c000 = x[0];
    map.c100 = x[1] - x[0];
    map.c010 = x[2] - x[0];
    map.c001 = x[4] - x[0];
    map.c110 = x[3] - x[2] - map.c100;
    map.c101 = x[5] - x[4] - map.c100;
    map.c011 = x[6] - x[4] - map.c010;
    map.c111 = x[7] - x[6] - x[5] + x[4] - map.c110;
    return map;
}

vec3 placeIn(Trilinear map, vec3 q) {
    return map.c000 + map.c100 * q.x + (map.c010 + map.c110 * q.x) * q.y +
           (map.c001 + map.c101 * q.x + (map.c011 + map.c111 * q.x) * q.y) * q.z;
}

// Columns: derivatives along u, v, t.
mat3 derivativesIn(Trilinear map, vec3 q) {
    return mat3(map.c100 + map.c110 * q.y + (map.c101 + map.c111 * q.y) * q.z,
                map.c010 + map.c110 * q.x + (map.c011 + map.c111 * q.x) * q.z,
                map.c001 + map.c101 * q.x + (map.c011 + map.c111 * q.x) * q.y);
}

// How long the image of the cube is along u, v and t, at most.
vec3 lengthsOf(Trilinear map) {
    mat3 d = derivativesIn(map, vec3(0.5));
    return vec3(length(d[0]) + length(map.c110) + length(map.c101), length(d[1]) + length(map.c110) + length(map.c011),
                length(d[2]));
}

// Which part of a cell: see shared/tube_blocks.h.
struct Part {
    uint cell;
    ivec3 cuts;   // along u, v, t
    ivec3 index;  // 0 <= index < cuts
};

uint packedPart(uint cell, ivec3 logCuts, ivec3 index) {
    uint cuts = uint(logCuts.x) | uint(logCuts.y) << 2u | uint(logCuts.z) << 4u;
    uint place = uint(index.x) | uint(index.y) << 3u | uint(index.z) << 6u;
    return cell | cuts << TUBE_PART_CELL_BITS | place << (TUBE_PART_CELL_BITS + 6u);
}

Part unpackedPart(uint packed_) {
    uint cuts = packed_ >> TUBE_PART_CELL_BITS;
    uint place = cuts >> 6u;
    Part part;
    part.cell = packed_ & ((1u << TUBE_PART_CELL_BITS) - 1u);
    part.cuts = ivec3(1 << int(cuts & 3u), 1 << int(cuts >> 2u & 3u), 1 << int(cuts >> 4u & 3u));
    part.index = ivec3(int(place & 7u), int(place >> 3u & 7u), int(place >> 6u & 7u));
    return part;
}

// The map of a part, over a unit cube of its own.
Trilinear partOf(Trilinear map, ivec3 cuts, ivec3 index) {
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = placeIn(map, vec3(index + ivec3(i & 1, i >> 1 & 1, i >> 2)) / vec3(cuts));
    }
    return trilinearOf(x);
}

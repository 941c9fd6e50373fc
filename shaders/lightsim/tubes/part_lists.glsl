// The lists of parts of cells, at PARTS_BINDING.

// Invocations that gather a part, each every so manieth row of its samples.
#ifndef GATHERS_PER_PART
#define GATHERS_PER_PART 1
#endif

layout(std430, binding = PARTS_BINDING) buffer PartBlock {
    TubePartsHeader header;
    uint parts[];
};

uint entryOf(uint list, uint index) {
    return index * TUBE_LISTS + list;
}

uint listedPart(uint list, uint index) {
    return parts[entryOf(list, index)];
}

// The list has so many parts, or more.
void countGroups(uint list, uint count) {
    uint invocations = count * (list == TUBE_GATHER_LIST || list == TUBE_CUT_LIST ? uint(GATHERS_PER_PART) : 1u);
    atomicMax(header.lists[list].groups.x, (invocations - 1u) / BAKE_GROUP_SIZE + 1u);
}

void listPart(uint list, uint packed_) {
    uint place = atomicAdd(header.lists[list].count, 1u);
    parts[entryOf(list, place)] = packed_;
    countGroups(list, place + 1u);
}

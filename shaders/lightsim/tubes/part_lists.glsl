// The lists of parts of cells, at PARTS_BINDING.
layout(std430, binding = PARTS_BINDING) buffer PartBlock {
    TubePartsHeader header;
    uint parts[];
};

uint listedPart(uint list, uint index) {
    return parts[list * TUBE_LIST_PARTS + index];
}

// The list has so many parts, or more.
void countGroups(uint list, uint count) {
    uint invocations = count * (list == TUBE_GATHER_LIST || list == TUBE_CUT_LIST ? TUBE_GATHERS_PER_PART : 1u);
    atomicMax(header.lists[list].groups.x, (invocations - 1u) / BAKE_GROUP_SIZE + 1u);
}

void listPart(uint list, uint packed_) {
    uint place = atomicAdd(header.lists[list].count, 1u);
    parts[list * TUBE_LIST_PARTS + place] = packed_;
    countGroups(list, place + 1u);
}

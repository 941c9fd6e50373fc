// The lists of parts of cells, at PARTS_BINDING.
layout(std430, binding = PARTS_BINDING) buffer PartBlock {
    TubePartsHeader header;
    uint parts[];
};

uint listedPart(uint list, uint index) {
    return parts[list * TUBE_LIST_PARTS + index];
}

void listPart(uint list, uint packed_) {
    uint place = atomicAdd(header.lists[list].count, 1u);
    parts[list * TUBE_LIST_PARTS + place] = packed_;
    atomicMax(header.lists[list].groups.x, place / BAKE_GROUP_SIZE + 1u);
}

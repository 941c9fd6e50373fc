// The cells that are deposited, and the lists of their parts.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/cell.glsl"

#include "lightsim/tubes/cell_rows.glsl"

layout(std430, binding = TUBE_PARTS_BINDING) readonly buffer PartBlock {
    TubePartsHeader header;
    uint parts[];
};

#include "lightsim/tubes/mirror_cut.glsl"
#include "lightsim/tubes/opaque_cut.glsl"

uint listedPart(uint list, uint index) {
    return parts[list * TUBE_LIST_PARTS + index];
}

// Place in the cell of a place in one of its parts.
vec3 placeInCell(Part part, vec3 q) {
    return (vec3(part.index) + q) / vec3(part.cuts);
}

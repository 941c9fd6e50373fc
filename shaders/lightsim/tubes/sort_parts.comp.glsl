// Sort, second part: the parts of uneven cells, one by one.
#include "lightsim/tubes/sort.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_UNEVEN_LIST].count) {
        return;
    }
    uint packed_ = listedPart(TUBE_UNEVEN_LIST, gl_GlobalInvocationID.x);
    Part part = unpackedPart(packed_);
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    listPart(isGathered(map, unevennessOf(map)) ? TUBE_GATHER_LIST : TUBE_LINE_LIST, packed_);
}

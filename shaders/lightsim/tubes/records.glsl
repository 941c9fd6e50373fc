// The cells that are deposited, and the lists of their parts.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/cell.glsl"

#include "lightsim/tubes/cell_rows.glsl"

#define PARTS_BINDING TUBE_PARTS_BINDING
#include "lightsim/tubes/part_lists.glsl"
#include "lightsim/tubes/mirror_cut.glsl"
#include "lightsim/tubes/opaque_cut.glsl"

// Place in the cell of a place in one of its parts.
vec3 placeInCell(Part part, vec3 q) {
    return (vec3(part.index) + q) / vec3(part.cuts);
}

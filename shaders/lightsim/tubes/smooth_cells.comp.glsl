// Sort, second part: cells that are even as a whole get the volumes that quadratics through their node give, and their parts
// are listed for the gather.
#include "lightsim/tubes/sort.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/tubes/volumes.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_NODES_BINDING) readonly buffer NodeBlock { TubeNode nodes[]; };

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_EVEN_LIST].count) {
        return;
    }
    Part part = unpackedPart(listedPart(TUBE_EVEN_LIST, gl_GlobalInvocationID.x));
    TubeJob job = jobs[part.cell / 4u];
    TubeNode node = nodes[job.node];
    vec4 volumes[2] = volumesOf(node, mapOf(part.cell), part.cell % 4u, frontOf(node, firstStepOf(job)),
                                frontOf(node, lastStepOf(job)));
    cellRows[cellRowIndex(part.cell, kFirstVolumeRow)] = volumes[0];
    cellRows[cellRowIndex(part.cell, kFirstVolumeRow + 1)] = volumes[1];
    listParts(TUBE_GATHER_LIST, part.cell, findMSB(part.cuts));
}

// Conform: where a vertex lies on the side of a coarser neighbour, it takes the place that the neighbour gives it, so that
// no gap opens between cells of different size.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { TubeConformity conformities[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    TubeConformity conformity = conformities[index];
    uint track = trackOf(conformity.vertex);
    uint first = trackOf(conformity.first);
    uint second = trackOf(conformity.second);
    for (int k = 0; k < TUBE_SAMPLES; ++k) {
        if (!hasSample(conformity.live, k)) {
            positions[track + uint(k)] = 0.5 * (positionAt(first + uint(k)) + positionAt(second + uint(k)));
            recordShare(track + uint(k), 0.5 * (shareAt(first + uint(k)) + shareAt(second + uint(k))));
        }
    }
}

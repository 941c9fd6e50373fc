// Deposit, of cells that are too weak to be refined though their corners part: between the corners there may be anything, so
// each corner stands for a quarter of the power, on its own path.
#include "lightsim/tubes/deposit.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const float kPointsPerVoxel = 2.0;
const int kMostPoints = 8;

void depositRay(vec3 from, vec3 to, vec3 powerLength) {
    vec3 along = to - from;
    int count = clamp(int(ceil(length(along) * kPointsPerVoxel)), 1, kMostPoints);
    vec3 point = powerLength / float(count);
    vec3 flux = fluxOf(point, unitOf(along));
    for (int i = 0; i < count; ++i) {
        addWhereInside(ivec3(floor(from + along * ((float(i) + 0.5) / float(count)))), point, flux);
    }
}

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_RAY_LIST].count) {
        return;
    }
    uint cell = unpackedPart(listedPart(TUBE_RAY_LIST, gl_GlobalInvocationID.x)).cell;
    CornerLight light = cornerLightOf(cell);
    for (int i = 0; i < 4; ++i) {
        depositRay(cells[cell].corners[i].xyz, cells[cell].corners[i + 4].xyz,
                   0.125 * (light.powerLength[i] + light.powerLength[i + 4]));
    }
}

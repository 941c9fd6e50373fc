// Deposit, of cells between whose corners there may be anything: corners, on their own paths, in place of what lies between.
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
    // a part of this list is a corner; its cuts say how many have the power between them
    Part part = unpackedPart(listedPart(TUBE_RAY_LIST, gl_GlobalInvocationID.x));
    CornerLight light = cornerLightOf(part.cell);
    int corner = part.index.x;
    vec3 from = cornerOf(part.cell, corner).xyz;
    vec3 to = cornerOf(part.cell, corner + 4).xyz;
    float hidden = partBeforeMirror(part.cell, corner);
    float lit = max(litPartAtCorner(part.cell, corner), hidden);
    depositRay(mix(from, to, hidden), mix(from, to, lit),
               powerLengthAt(light, vec3(corner & 1, corner >> 1, 0.5)) * ((lit - hidden) / float(part.cuts.x)));
}

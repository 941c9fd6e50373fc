// Deposit of the eikonal, from one list of parts (PART_LIST): points of the cells, close together, say what the optical path is
// in the middle of the voxel that they are in, and a voxel keeps the least. About a point the eikonal is flat: it changes by
// the index along the ray.
#include "lightsim/tubes/records.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_EIKONAL_BINDING) buffer EikonalBlock { uint leastPaths[]; };  // bits of floats >= 0

const float kPointsPerVoxel = 3.0;  // along each axis
const int kMostPoints = 12;         // along each axis of a part
// Points count that are not further from the middle of a voxel, along each axis: there a front of radius r voxels is off by
// at most 0.13/r of a voxel, and points that close together leave no voxel out.
const float kReach = 0.3;

// What a point x [voxels] with optical path `path` says; over the displacement `along` [voxels] the path changes by `change`.
void offerPath(vec3 x, vec3 along, float path, float change) {
    ivec3 voxel = ivec3(floor(x));
    vec3 toMiddle = vec3(voxel) + 0.5 - x;
    if (any(lessThan(voxel, ivec3(0))) || any(greaterThanEqual(voxel, domain.size)) || voxel.z < settings.slabBegin ||
        voxel.z >= settings.slabEnd || largestOf(abs(toMiddle)) > kReach) {
        return;
    }
    float pathAtMiddle = path + change * dot(along, toMiddle) / max(dot(along, along), 1.0e-30);
    uint index = (uint(voxel.z - settings.slabBegin) * uint(domain.size.y) + uint(voxel.y)) * uint(domain.size.x) + uint(voxel.x);
    atomicMin(leastPaths[index], floatBitsToUint(max(pathAtMiddle, 0.0)));
}

#if PART_LIST == TUBE_RAY_LIST

void offerPart(Part part) {
    int corner = part.index.x;
    vec3 from = cornerOf(part.cell, corner).xyz;
    vec3 along = cornerOf(part.cell, corner + 4).xyz - from;
    float path = cornerOf(part.cell, 0).w;
    float change = cornerOf(part.cell, 1).w - path;
    float hidden = partBeforeMirror(part.cell, corner);
    float lit = max(litPartAtCorner(part.cell, corner), hidden);
    int count = clamp(int(ceil(length(along) * kPointsPerVoxel)), 1, kMostPoints);
    for (int i = 0; i < count; ++i) {
        float t = mix(hidden, lit, (float(i) + 0.5) / float(count));
        offerPath(from + along * t, along, path + change * t, change);
    }
}

#else

void offerPart(Part part) {
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    vec3 extents = lengthsOf(map);
    ivec3 counts = ivec3(clamp(ceil(extents * kPointsPerVoxel), vec3(1.0), vec3(float(kMostPoints))));
    float path = cornerOf(part.cell, 0).w;
    float change = cornerOf(part.cell, 1).w - path;
    for (int i = 0; i < counts.x * counts.y * counts.z; ++i) {
        vec3 q = (vec3(ivec3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y))) + 0.5) / vec3(counts);
        vec3 place = placeInCell(part, q);
        if (isLit(part.cell, place)) {
            offerPath(placeIn(map, q), derivativesIn(map, q)[2], path + change * place.z, change / float(part.cuts.z));
        }
    }
}

#endif

void main() {
    if (gl_GlobalInvocationID.x < header.lists[PART_LIST].count) {
        offerPart(unpackedPart(listedPart(PART_LIST, gl_GlobalInvocationID.x)));
    }
}

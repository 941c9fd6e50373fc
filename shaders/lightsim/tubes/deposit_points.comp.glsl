// Deposit, of parts near folds and foci: points, each a share of the part's power x length, go to the voxels that hold them.
#include "lightsim/tubes/deposit.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const float kPointsPerVoxel = 4.0;  // along each axis
const int kMostPoints = 12;         // along each axis of a part

// Points a quarter of a voxel apart, or fewer if they carry less than matters.
ivec3 pointsFor(vec3 extents, float powerLength, float pointPower) {
    vec3 wanted = clamp(extents * kPointsPerVoxel, vec3(1.0), vec3(float(kMostPoints)));
    float enough = powerLength / max(pointPower * settings.depositScale, 1.0e-30);
    wanted *= min(1.0, pow(max(enough, 1.0e-6) / (wanted.x * wanted.y * wanted.z), 1.0 / 3.0));
    return max(ivec3(wanted + 0.5), ivec3(1));
}

// A point of a part in the light, and what it weighs: where opaque matter ends the light, points lie in front of it.
struct LitPoint {
    vec3 q;
    float weight;
};

LitPoint litPointOf(Part part, vec3 q) {
#ifdef EFFECT_OPAQUE
    float lit = litPartAt(part.cell, placeInCell(part, q).xy) * float(part.cuts.z) - float(part.index.z);
    float weight = clamp(lit, 0.0, 1.0);
    return LitPoint(vec3(q.xy, q.z * weight), weight);
#else
    return LitPoint(q, 1.0);
#endif
}

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_POINT_LIST].count) {
        return;
    }
    Part part = unpackedPart(listedPart(TUBE_POINT_LIST, gl_GlobalInvocationID.x));
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    vec3 extents = lengthsOf(map);
    CornerLight corners = cornerLightOf(part.cell);
    float cut = 1.0 / float(part.cuts.x * part.cuts.y * part.cuts.z);
    ivec3 counts = pointsFor(extents, largestOf(powerLengthAt(corners, placeInCell(part, vec3(0.5)))) * cut,
                              cellRow(part.cell, kPowerRow).w);
    float portion = cut / float(counts.x * counts.y * counts.z);
    // voxel after voxel, for invocations wait for each other where sums are added to
    vec3 spacing = 1.0 / vec3(counts);
    ivec3 index = ivec3(0);
    LitPoint at = litPointOf(part, 0.5 * spacing);
    vec3 x = placeIn(map, at.q);
    while (index.z < counts.z) {
        ivec3 voxel = ivec3(floor(x));
        vec3 powerLength = vec3(0.0);
        vec3 last;
        do {
            last = at.q;
            vec3 place = placeInCell(part, at.q);
            powerLength += isPastMirror(part.cell, place) ? powerLengthAt(corners, place) * (portion * at.weight) : vec3(0.0);
            index = following(index, ivec3(0), counts - 1);
            at = litPointOf(part, (vec3(index) + 0.5) * spacing);
            x = placeIn(map, at.q);
        } while (index.z < counts.z && ivec3(floor(x)) == voxel);
        addWhereInside(voxel, powerLength, fluxOf(powerLength, unitOf(derivativesIn(map, last)[2])));
    }
}

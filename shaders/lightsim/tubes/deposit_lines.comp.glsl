// Deposit, of parts near folds and foci: lines along the light, each a share of the part's power x length, which voxels get in
// proportion to the length that lies in them.
#include "lightsim/tubes/deposit.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const float kLinesPerVoxel = 2.0;  // along u and v; along t it counts in what a line may carry
const int kMostLines = 6;          // along each axis of a part
const int kMostVoxels = 16;        // that a line passes: it is at most kLongestPart long
const float kAhead = 1.0e-3;       // [voxels]: the place so far ahead says which voxel a line is in; floats tell 3e-5

// Lines half a voxel apart, or fewer if they carry less than matters.
ivec2 linesFor(vec3 extents, float powerLength, float leastPower) {
    vec3 wanted = clamp(extents * kLinesPerVoxel, vec3(1.0), vec3(float(kMostLines)));
    float enough = powerLength / max(leastPower * settings.depositScale, 1.0e-30);
    wanted *= min(1.0, pow(max(enough, 1.0e-6) / (wanted.x * wanted.y * wanted.z), 1.0 / 3.0));
    return max(ivec2(wanted.xy + 0.5), ivec2(1));
}

// A part's places with one u and v, for t from 0 to 1.
struct Line {
    vec2 uv;
    vec3 start;  // [voxels]
    vec3 along;
    float first, last;  // between which it is lit
};

Line lineAt(Part part, Trilinear map, vec2 uv) {
    vec2 place = placeInCell(part, vec3(uv, 0.0)).xy;
    vec2 lit = vec2(partBeforeMirrorAt(part.cell, place), litPartAt(part.cell, place));
    lit = clamp(lit * float(part.cuts.z) - float(part.index.z), 0.0, 1.0);
    return Line(uv, placeIn(map, vec3(uv, 0.0)), derivativesIn(map, vec3(uv, 0.0))[2], lit.x, lit.y);
}

// Where a line leaves a voxel that it is in.
float exitFrom(ivec3 voxel, Line line) {
    vec3 face = vec3(voxel) + vec3(greaterThan(line.along, vec3(0.0)));
    vec3 t = mix((face - line.start) / line.along, vec3(1.0e30), equal(line.along, vec3(0.0)));
    return min(t.x, min(t.y, t.z));
}

// Adds what a line brings from t = `begin` to where it leaves the voxel that it is in then, or ends: there.
float depositOf(Line line, float begin, Part part, CornerLight corners, float portion) {
    float ahead = begin + kAhead / max(length(line.along), kAhead);
    ivec3 voxel = ivec3(floor(line.start + line.along * ahead));
    float end = min(max(exitFrom(voxel, line), ahead), line.last);
    vec3 middle = placeInCell(part, vec3(line.uv, 0.5 * (begin + end)));
    vec3 powerLength = powerLengthAt(corners, middle) * (portion * max(end - begin, 0.0));
    addWhereInside(voxel, powerLength, fluxOf(powerLength, unitOf(line.along)));
    return end;
}

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_LINE_LIST].count) {
        return;
    }
    Part part = unpackedPart(listedPart(TUBE_LINE_LIST, gl_GlobalInvocationID.x));
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    CornerLight corners = cornerLightOf(part.cell);
    float cut = 1.0 / float(part.cuts.x * part.cuts.y * part.cuts.z);
    ivec2 counts = linesFor(lengthsOf(map), brightestOf(powerLengthAt(corners, placeInCell(part, vec3(0.5)))) * cut,
                            cellRow(part.cell, kPowerRow).w);
    float portion = cut / float(counts.x * counts.y);
    // voxel after voxel of line after line in one loop, for invocations wait for the one that has most to do
    vec2 spacing = 1.0 / vec2(counts);
    ivec2 index = ivec2(0);
    float from = 0.0;
    int most = counts.x * counts.y * kMostVoxels;
    for (int i = 0; i < most && index.y < counts.y; ++i) {
        Line line = lineAt(part, map, (vec2(index) + 0.5) * spacing);
        from = depositOf(line, max(from, line.first), part, corners, portion);
        if (from >= line.last) {
            from = 0.0;
            index = index.x + 1 < counts.x ? ivec2(index.x + 1, index.y) : ivec2(0, index.y + 1);
        }
    }
}

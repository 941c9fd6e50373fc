// What sorts cells and their parts into the lists of those that are deposited alike.
// A part is gathered, voxel by voxel, if irradiance changes little from one sample to the next: that is the error of taking
// a voxel's mean from samples. Where it changes more, near folds and foci, the part is small in space, for the light is
// compressed there, and lines along it carry its power x length. Each kernel looks at one kind of thing, for invocations that run
// together wait for the one that has most to do.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/cell.glsl"
#include "lightsim/tubes/cell_rows.glsl"

layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { TubeJob jobs[]; };
layout(std430, binding = TUBE_SORT_RECORDS_BINDING) writeonly buffer RecordBlock { vec4 cellRows[]; };
#define PARTS_BINDING TUBE_SORT_PARTS_BINDING
#include "lightsim/tubes/part_lists.glsl"

const float kLongestPart = 4.0;     // [voxels]: bounds the voxels that a gather looks at
const float kLongestUneven = 1.0;   // [voxels]: uneven cells are cut to that, so that their even parts can be gathered
const int kMostLogCuts = 3;         // along each axis
const float kFolded = 1.0e9;        // unevenness where the map turns inside out
// Of the volume that a sample stands for: parts smaller than that are lines, whatever their irradiance does, so that no
// sample can be worth many times what its part carries.
const float kLeastVolume = 1.0 / 64.0;

uint firstStepOf(TubeJob job) {
    return job.steps % (1u << TUBE_JOB_COUNT_BIT);
}

uint lastStepOf(TubeJob job) {
    return firstStepOf(job) + (job.steps >> TUBE_JOB_COUNT_BIT) % (1u << (TUBE_JOB_WEAK_BIT - TUBE_JOB_COUNT_BIT));
}

bool isWeak(TubeJob job) {
    return job.steps >> TUBE_JOB_WEAK_BIT != 0u;
}

Trilinear mapOf(vec4 corners[8]) {
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = corners[i].xyz;
    }
    return trilinearOf(x);
}

// How much the density of the map changes over the distance between two samples, along u, v and t, in logarithm: large
// where the map folds.
vec3 unevennessOf(Trilinear map) {
    float volume[8];
    float least = 1.0e30;
    float most = -1.0e30;
    for (int i = 0; i < 8; ++i) {
        volume[i] = determinant(derivativesIn(map, vec3(ivec3(i & 1, i >> 1 & 1, i >> 2))));
        least = min(least, volume[i]);
        most = max(most, volume[i]);
    }
    if (!(least * most > 0.0)) {
        return vec3(kFolded);
    }
    mat3 middle = derivativesIn(map, vec3(0.5));
    float middleVolume = abs(determinant(middle));
    // thickness between the two faces across each axis
    vec3 thickness = middleVolume / max(vec3(length(cross(middle[1], middle[2])), length(cross(middle[2], middle[0])),
                                             length(cross(middle[0], middle[1]))), vec3(1.0e-30));
    vec3 ratio = vec3(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 8; ++i) {
            if ((i >> axis & 1) == 0) {
                float along = volume[i | 1 << axis] / volume[i];
                ratio[axis] = max(ratio[axis], max(along, 1.0 / along));
            }
        }
    }
    float spacing = 1.0 / float(tube.samplesPerVoxel);
    return log(ratio) * spacing / max(thickness, vec3(1.0e-9));
}

bool isGathered(Trilinear map, vec3 unevenness) {
    float spacing = 1.0 / float(tube.samplesPerVoxel);
    float volume = abs(determinant(derivativesIn(map, vec3(0.5))));
    return largestOf(unevenness) < tube.maxUnevenness &&
           volume > kLeastVolume * spacing * spacing * spacing;
}

// Cuts that make parts at most kLongestPart long, and unless they go `together` to kLongestUneven, so that even ones can be
// gathered. A part's length decides first; there are at most TUBE_MAX_PARTS of a cell.
ivec3 logCutsOf(vec3 extents, bool together) {
    ivec3 logCuts = ivec3(0);
    int total = 0;
    for (int i = 0; i < TUBE_MOST_LOG_CUTS; ++i) {
        vec3 lengths = extents / vec3(1 << logCuts.x, 1 << logCuts.y, 1 << logCuts.z);
        int axis = lengths.x >= lengths.y ? (lengths.x >= lengths.z ? 0 : 2) : (lengths.y >= lengths.z ? 1 : 2);
        bool tooLong = lengths[axis] > kLongestPart;
        bool uneven = !together && lengths[axis] > kLongestUneven;
        if (logCuts[axis] < kMostLogCuts && (tooLong || (uneven && total < 3))) {
            ++logCuts[axis];
            ++total;
        }
    }
    return logCuts;
}

// Lists all parts of a cell that is cut so.
void listParts(uint list, uint cell, ivec3 logCuts) {
    uint count = 1u << uint(logCuts.x + logCuts.y + logCuts.z);
    uint place = atomicAdd(header.lists[list].count, count);
    for (uint i = 0u; i < count; ++i) {
        ivec3 index = ivec3(i, i >> uint(logCuts.x), i >> uint(logCuts.x + logCuts.y)) & ((ivec3(1) << logCuts) - 1);
        parts[entryOf(list, place + i)] = packedPart(cell, logCuts, index);
    }
    countGroups(list, place + count);
}

// A cell that is not even: part by part, or as lines if its node is not resolved anyway, for want of power.
void listUneven(uint cell, bool weak, vec3 extents) {
    listParts(weak ? TUBE_LINE_LIST : TUBE_UNEVEN_LIST, cell, logCutsOf(extents, weak));
}

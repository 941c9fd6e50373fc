// Sort: the cells of nodes over steps, cut into parts, each listed for the deposit that suits it. Four invocations a job,
// one for each sub-cell.
// A part is gathered, voxel by voxel, if irradiance changes little from one sample to the next: that is the error of taking
// a voxel's mean from samples. Where it changes more, near folds and foci, the part is small in space, for the light is
// compressed there, and points of power x length are splatted.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/tubes/cell.glsl"
#include "lightsim/tubes/volumes.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { TubeJob jobs[]; };
layout(std430, binding = TUBE_SORT_RECORDS_BINDING) writeonly buffer RecordBlock { TubeCell cells[]; };
layout(std430, binding = TUBE_NODES_BINDING) readonly buffer NodeBlock { TubeNode nodes[]; };
layout(std430, binding = TUBE_SORT_PARTS_BINDING) buffer PartBlock {
    TubePartsHeader header;
    uint parts[];
};

const float kLongestPart = 3.0;   // [voxels]: bounds the voxels that a gather looks at
const float kLongestPoints = 1.0;   // [voxels]: parts that are splatted are cut to that
const float kPointShare = 5.0e-3;     // of the power that is not worth another ray
const float kFolded = 1.0e9;          // unevenness where the map turns inside out
const int kMostLogCuts = 3;         // along each axis
// Of the volume that a sample stands for: parts smaller than that are points, whatever their irradiance does, so that no
// sample can be worth many times what its part carries.
const float kLeastVolume = 1.0 / 64.0;

TubeCell cellOf(TubeJob job, uint quarter) {
    TubeNode node = nodes[job.node];
    TubeCell cell;
    uint low = quarter % 2u + 3u * (quarter / 2u);
    uint first = job.steps % (1u << TUBE_JOB_COUNT_BIT);
    uint last = first + (job.steps >> TUBE_JOB_COUNT_BIT) % (1u << (TUBE_JOB_WEAK_BIT - TUBE_JOB_COUNT_BIT));
    for (uint i = 0u; i < 4u; ++i) {
        uint track = trackOf(node.vertices[low + i % 2u + 3u * (i / 2u)]);
        float arc = 0.0;
        for (uint k = first + 1u; k <= last; ++k) {
            arc += positions[track + k].w;
        }
        cell.corners[i] = vec4((positions[track + first].xyz - domainMin) / domainVoxel, 0.0);
        cell.corners[i + 4u] = vec4((positions[track + last].xyz - domainMin) / domainVoxel, arc / domainVoxel);
        cell.shares[i] = shares[track + first];
        cell.shares[i + 4u] = shares[track + last];
    }
    float pathBefore = frames[node.frameIndex].pathBefore + float(tube.firstStep) * settings.opticalStep;
    cell.corners[0].w = pathBefore + float(first) * settings.opticalStep;
    cell.corners[1].w = pathBefore + float(last) * settings.opticalStep;
    cell.volumes = volumesOf(node, cell, quarter, first, last);
    cell.power = frames[node.frameIndex].strength * node.launchShare[quarter];
    cell.pointPower = kPointShare * frames[node.frameIndex].splitPower;
    return cell;
}

bool meetsDomain(vec3 x[8]) {
    vec3 low = x[0];
    vec3 high = x[0];
    for (int i = 1; i < 8; ++i) {
        low = min(low, x[i]);
        high = max(high, x[i]);
    }
    return all(lessThan(low, vec3(domainSize))) && all(greaterThan(high, vec3(0.0)));
}

// Longest edges of a cell along u, v, t [voxels].
vec3 extentsOf(vec3 x[8]) {
    vec3 extents = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        extents.x = max(extents.x, distance(x[2 * i], x[2 * i + 1]));
        extents.y = max(extents.y, distance(x[i + 2 * (i / 2)], x[i + 2 * (i / 2) + 2]));
        extents.z = max(extents.z, distance(x[i], x[i + 4]));
    }
    return extents;
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
    vec3 change = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 8; ++i) {
            if ((i >> axis & 1) == 0) {
                change[axis] = max(change[axis], abs(log(volume[i | 1 << axis] / volume[i])));
            }
        }
    }
    float spacing = 1.0 / float(tube.samplesPerVoxel);
    return change * spacing / max(thickness, vec3(1.0e-9));
}

bool isGathered(Trilinear map, vec3 unevenness) {
    float spacing = 1.0 / float(tube.samplesPerVoxel);
    float volume = abs(determinant(derivativesIn(map, vec3(0.5))));
    return largestOf(unevenness) < tube.maxUnevenness &&
           volume > kLeastVolume * spacing * spacing * spacing;
}

// Cuts that make parts at most kLongestPart long, and halves where light is uneven, so that an even half can be gathered.
// A part's length decides first; there are at most TUBE_MAX_PARTS of a cell.
ivec3 logCutsOf(vec3 extents, bool gathered) {
    ivec3 logCuts = ivec3(0);
    int total = 0;
    for (int i = 0; i < TUBE_MOST_LOG_CUTS; ++i) {
        vec3 lengths = extents / vec3(1 << logCuts.x, 1 << logCuts.y, 1 << logCuts.z);
        int axis = lengths.x >= lengths.y ? (lengths.x >= lengths.z ? 0 : 2) : (lengths.y >= lengths.z ? 1 : 2);
        bool tooLong = lengths[axis] > kLongestPart;
        bool uneven = !gathered && lengths[axis] > kLongestPoints;
        if (logCuts[axis] < kMostLogCuts && (tooLong || (uneven && total < 3))) {
            ++logCuts[axis];
            ++total;
        }
    }
    return logCuts;
}

void listPart(uint list, uint packed_) {
    uint place = atomicAdd(header.lists[list].count, 1u);
    parts[list * TUBE_LIST_PARTS + place] = packed_;
    atomicMax(header.lists[list].groups.x, place / BAKE_GROUP_SIZE + 1u);
}

// Whether the corners of a cell are in different matter, where light goes at another speed or is taken up at another rate.
bool isMixed(TubeCell cell) {
    const float kSameLength = 0.9;     // ratio of arc lengths in one medium, whose index varies by less than that
    const float kSameLoss = 0.03;      // difference of the losses along the steps in one medium
    vec3 leastLoss = vec3(1.0);
    vec3 mostLoss = vec3(0.0);
    float shortest = 1.0e30;
    float longest = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec3 loss = 1.0 - cell.shares[i + 4].rgb / max(cell.shares[i].rgb, vec3(1.0e-30));
        leastLoss = min(leastLoss, loss);
        mostLoss = max(mostLoss, loss);
        shortest = min(shortest, cell.corners[i + 4].w);
        longest = max(longest, cell.corners[i + 4].w);
    }
    return shortest < kSameLength * longest || largestOf(mostLoss - leastLoss) > kSameLoss;
}

// Cells between whose corners there may be anything are left to rays; true if this is one. Corners that have parted far in
// one medium share the power. Those of an unresolved node in different matter, with more than a voxel between them, leave it
// all to the node's centre: it is always a ray of its own, while corners may be made to conform to others, and then are where
// no light goes.
bool listRays(TubeCell cell, uint self, bool isWeak, vec3 extents) {
    const float kLongestCell = 12.0;   // [voxels]
    const float kLongestMixed = 1.5;   // [voxels]
    float across = max(extents.x, extents.y);
    if (isWeak && across > kLongestMixed && isMixed(cell)) {
        int centre = 3 - int(self % 4u);  // the corner of a quarter that is the centre of its node
        listPart(TUBE_RAY_LIST, packedPart(self, ivec3(0), ivec3(centre, 0, 0)));
        return true;
    }
    if (across > kLongestCell) {
        for (int corner = 0; corner < 4; ++corner) {
            listPart(TUBE_RAY_LIST, packedPart(self, ivec3(2, 0, 0), ivec3(corner, 0, 0)));
        }
        return true;
    }
    return false;
}

void main() {
    uint self = gl_GlobalInvocationID.x;
    if (self >= 4u * tube.itemCount) {
        return;
    }
    TubeCell cell = cellOf(jobs[self / 4u], self % 4u);
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = cell.corners[i].xyz;
    }
    float brightest = 0.0;
    for (int i = 0; i < 8; ++i) {
        brightest = max(brightest, largestOf(cell.shares[i].rgb));
    }
    if (brightest <= 0.0 || !meetsDomain(x)) {
        return;
    }
    cells[self] = cell;
    vec3 extents = extentsOf(x);
    bool isWeak = jobs[self / 4u].steps >> TUBE_JOB_WEAK_BIT != 0u;
    if (listRays(cell, self, isWeak, extents)) {
        return;
    }
    Trilinear map = trilinearOf(x);
    vec3 unevenness = unevennessOf(map);
    if (unevenness.x >= kFolded) {
        atomicAdd(header.foldedCells, 1u);
    }
    ivec3 logCuts = logCutsOf(extents, isGathered(map, unevenness));
    ivec3 cuts = ivec3(1 << logCuts.x, 1 << logCuts.y, 1 << logCuts.z);
    for (int i = 0; i < cuts.x * cuts.y * cuts.z; ++i) {
        ivec3 index = ivec3(i % cuts.x, i / cuts.x % cuts.y, i / (cuts.x * cuts.y));
        Trilinear part = partOf(map, cuts, index);
        bool gathered = isGathered(part, unevennessOf(part));
        listPart(gathered ? TUBE_GATHER_LIST : TUBE_POINT_LIST, packedPart(self, logCuts, index));
    }
}

// Sort: the cells of nodes over steps. Cells that are even as a whole are listed for smooth_cells, others part by part for
// sort_parts; between the corners of some there may be anything, and rays are deposited in their place. Four invocations a
// job, one for each sub-cell.
#include "lightsim/tubes/sort.glsl"
#include "lightsim/tubes/tracks.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_NODES_BINDING) readonly buffer NodeBlock { TubeNode nodes[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };
layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
#include "lightsim/tubes/opaque_front.glsl"

const float kLineShare = 0.02;   // of the power that is not worth another ray

// A cell while it is made: see cell_rows.glsl.
struct Cell {
    vec4 corners[8];
    vec4 shares[8];
    vec3 power;
    float linePower;
    vec4 litParts;
};

// Of a sub-cell's four corners before its steps, in the order of a cell's.
uint cornerVertex(TubeJob job, uint quarter, uint corner) {
    uint low = quarter % 2u + 3u * (quarter / 2u);
    return nodes[job.node].vertices[low + corner % 2u + 3u * (corner / 2u)];
}

Cell cellOf(TubeJob job, uint quarter) {
    uint frameIndex = nodes[job.node].frameIndex;
    Cell cell;
    uint first = firstStepOf(job);
    uint last = lastStepOf(job);
    for (uint i = 0u; i < 4u; ++i) {
        uint track = trackOf(cornerVertex(job, quarter, i));
        float arc = 0.0;
        for (uint k = first + 1u; k <= last; ++k) {
            arc += positionAt(track + k).w;
        }
        cell.corners[i] = vec4((positionAt(track + first).xyz - domain.min) / domain.voxel, 0.0);
        cell.corners[i + 4u] = vec4((positionAt(track + last).xyz - domain.min) / domain.voxel, arc / domain.voxel);
        cell.shares[i] = shareAt(track + first);
        cell.shares[i + 4u] = shareAt(track + last);
    }
    float pathBefore = frames[frameIndex].pathBefore + float(tube.firstStep) * settings.opticalStep;
    cell.corners[0].w = pathBefore + float(first) * settings.opticalStep;
    cell.corners[1].w = pathBefore + float(last) * settings.opticalStep;
    cell.litParts = vec4(1.0);
    cell.power = frames[frameIndex].strength * nodes[job.node].launchShare[quarter];
    cell.linePower = kLineShare * frames[frameIndex].splitPower;
    return cell;
}

// Volumes are its own until others are found.
void store(uint self, Cell cell) {
    int rows = cellRowIndex(self, 0);
    for (int i = 0; i < 8; ++i) {
        cellRows[rows + kFirstCornerRow + i] = cell.corners[i];
    }
#if BANDS == 3
    for (int i = 0; i < 8; ++i) {
        cellRows[rows + kFirstShareRow + i] = cell.shares[i];
    }
#else
    for (int i = 0; i < 2; ++i) {
        cellRows[rows + kFirstShareRow + i] =
            vec4(cell.shares[4 * i].r, cell.shares[4 * i + 1].r, cell.shares[4 * i + 2].r, cell.shares[4 * i + 3].r);
    }
#endif
#ifdef FOLLOW_REFLECTIONS
    for (int i = 0; i < 2; ++i) {
        cellRows[rows + kFirstMirrorRow + i] =
            vec4(cell.shares[4 * i].a, cell.shares[4 * i + 1].a, cell.shares[4 * i + 2].a, cell.shares[4 * i + 3].a);
    }
#endif
    cellRows[rows + kFirstVolumeRow] = vec4(TUBE_OWN_VOLUME);
    cellRows[rows + kPowerRow] = vec4(cell.power, cell.linePower);
#ifdef EFFECT_OPAQUE
    cellRows[rows + kLitPartsRow] = cell.litParts;
#endif
}

#ifdef EFFECT_OPAQUE
// Arc lengths end at opaque matter; the cell goes on, and notes where its light ends. Corners without light go by the others.
// A step that meets matter ends with the share that is left there; none is left behind it, from the beginning of the next.
void cutAtMatter(inout Cell cell) {
    const float kWhole = 0.999;  // of the chord: arcs of other steps are no shorter
    float sum = 0.0;
    float count = 0.0;
    for (int i = 0; i < 4; ++i) {
        float chord = distance(cell.corners[i].xyz, cell.corners[i + 4].xyz);
        float arc = cell.corners[i + 4].w;
        bool cut = arc < kWhole * chord;
        cell.litParts[i] = cut ? arc / chord : 1.0;
        cell.corners[i + 4].w = cut ? chord : arc;
        cell.shares[i].rgb = largestOf(cell.shares[i + 4].rgb) > 0.0 ? cell.shares[i].rgb : vec3(0.0);
        if (largestOf(cell.shares[i].rgb) > 0.0) {
            sum += cell.litParts[i];
            count += 1.0;
        }
    }
    for (int i = 0; i < 4; ++i) {
        cell.litParts[i] = count > 0.0 && largestOf(cell.shares[i].rgb) == 0.0 ? sum / count : cell.litParts[i];
    }
}
#endif

#ifdef EFFECT_OPAQUE
vec4 endsOf(TubeJob job, uint quarter) {
    vec4 ends;
    for (uint i = 0u; i < 4u; ++i) {
        ends[i] = endOf(cornerVertex(job, quarter, i));
    }
    return ends;
}

// Whether one surface ends the light of all four corners, in whichever of the window's steps.
bool isOneSurface(vec4 ends) {
    float latest = max(max(ends.x, ends.y), max(ends.z, ends.w));
    return latest < 0.5 * kNoEnd && isOneSurface(0.5 * (ends.x + ends.w), 0.5 * (ends.y + ends.z));
}

// The same of a cell that such a surface crosses: the surface is bilinear, and a corner that it has passed already has the light
// that the others have.
void cutAtSurface(inout Cell cell, vec4 ends, float first, float last) {
    vec4 before = vec4(0.0);
    vec4 after = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        if (ends[i] > first) {
            before += vec4(cell.shares[i].rgb, 1.0);
            after += vec4(cell.shares[i + 4].rgb, 1.0);
        }
    }
    for (int i = 0; i < 4; ++i) {
        if (ends[i] <= first) {
            cell.shares[i].rgb = before.rgb / max(before.w, 1.0);
            cell.shares[i + 4].rgb = after.rgb / max(after.w, 1.0);
        }
        if (ends[i] < last) {
            cell.corners[i + 4].w = distance(cell.corners[i].xyz, cell.corners[i + 4].xyz);
        }
        cell.litParts[i] = (ends[i] - first) / (last - first);
    }
}
#endif

bool meetsDomain(Cell cell) {
    vec3 low = cell.corners[0].xyz;
    vec3 high = low;
    for (int i = 1; i < 8; ++i) {
        low = min(low, cell.corners[i].xyz);
        high = max(high, cell.corners[i].xyz);
    }
    return all(lessThan(low, vec3(domain.size))) && all(greaterThan(high, vec3(0.0)));
}

bool hasLight(Cell cell) {
    float brightest = 0.0;
    for (int i = 0; i < 8; ++i) {
        brightest = max(brightest, largestOf(cell.shares[i].rgb));
    }
    return brightest > 0.0;
}

// Longest edges of a cell along u, v, t [voxels].
vec3 extentsOf(Cell cell) {
    vec3 extents = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        extents.x = max(extents.x, distance(cell.corners[2 * i].xyz, cell.corners[2 * i + 1].xyz));
        extents.y = max(extents.y, distance(cell.corners[i + 2 * (i / 2)].xyz, cell.corners[i + 2 * (i / 2) + 2].xyz));
        extents.z = max(extents.z, distance(cell.corners[i].xyz, cell.corners[i + 4].xyz));
    }
    return extents;
}

// Whether the corners of a cell are in different matter that takes up light at different rates, or turns it back: where light goes
// at another speed, it may.
bool isMixed(Cell cell) {
#if defined(EFFECT_ABSORPTION) || defined(EFFECT_SCATTERING) || defined(FOLLOW_REFLECTIONS)
    const float kSameLength = 0.9;  // ratio of arc lengths in one medium, whose index varies by less than that
    float shortest = 1.0e30;
    float longest = 0.0;
    for (int i = 4; i < 8; ++i) {
        shortest = min(shortest, cell.corners[i].w);
        longest = max(longest, cell.corners[i].w);
    }
    if (shortest < kSameLength * longest) {
        return true;
    }
#endif
    const float kSameLoss = 0.03;  // difference of the losses along the steps in one medium
    vec3 leastLoss = vec3(1.0);
    vec3 mostLoss = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 loss = 1.0 - cell.shares[i + 4].rgb / max(cell.shares[i].rgb, vec3(1.0e-30));
        leastLoss = min(leastLoss, loss);
        mostLoss = max(mostLoss, loss);
    }
    return largestOf(mostLoss - leastLoss) > kSameLoss;
}

// Cells between whose corners there may be anything are left to rays; true if this is one. Corners that have parted far in
// one medium share the power. Those of an unresolved node in such matter, with more than a voxel between them, leave it all to
// the node's centre: it is always a ray of its own, while corners may be made to conform to others, and then are where
// no light goes.
bool listRays(Cell cell, uint self, bool weak, vec3 extents) {
    const float kLongestCell = 12.0;   // [voxels]
    const float kLongestMixed = 1.5;   // [voxels]
    float across = max(extents.x, extents.y);
    if (weak && across > kLongestMixed && isMixed(cell)) {
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
    TubeJob job = jobs[self / 4u];
    Cell cell = cellOf(job, self % 4u);
#ifdef EFFECT_OPAQUE
    vec4 ends = endsOf(job, self % 4u);
    if (isOneSurface(ends)) {
        cutAtSurface(cell, ends, float(firstStepOf(job)), float(lastStepOf(job)));
    } else {
        cutAtMatter(cell);
    }
#endif
    if (!hasLight(cell) || !meetsDomain(cell)) {
        return;
    }
    Trilinear map = mapOf(cell.corners);
    cell.corners[2].w = abs(determinant(derivativesIn(map, vec3(0.5))));
    store(self, cell);
    vec3 extents = extentsOf(cell);
    if (listRays(cell, self, isWeak(job), extents)) {
        return;
    }
    vec3 unevenness = unevennessOf(map);
    if (unevenness.x >= kFolded) {
        atomicAdd(header.foldedCells, 1u);
    }
    if (isGathered(map, unevenness)) {
        listPart(TUBE_EVEN_LIST, packedPart(self, logCutsOf(extents, true), ivec3(0)));
    } else {
        listUneven(self, isWeak(job), extents);
    }
}

// Refine: looks at every patch after its step. Those that are done are listed for retire; those that have grown too long are
// halved across their longer side, and listed for split to launch the new corners; the others live on, folded or not. (The
// method of 2007 ends those that fold: settings.foldsEnd.)
#include "lightsim/bake.glsl"
#include "lightsim/share.glsl"
#include "physics/tube.glsl"
#include "shared/domain_block.h"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = BAKE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };
layout(std430, binding = BAKE_RECORDS_BINDING) buffer RecordBlock { LaunchRecord records[]; };

shared uint groupEvaluations;

struct Shape {
    float sideU;          // longer of the two sides along u [scene units]
    float sideV;
    bool nearDomain;      // its bounding box meets the domain
    uint insideCorners;
    bool ended;           // nothing of it will be in the domain any more
    vec3 remaining;       // mean share of the launched power in corners inside or still to come
    float spread;         // largest difference of the corners' mean shares over the last step, by band
    uint orientation;
};

// Corners whose shares differ by more than this part of the largest are too far apart to be interpolated between, as long
// as the patch is longer than this part of the longest side: what is smaller, a voxel's mean does not show.
const float kMaxSpread = 0.1;
const float kResolvedSide = 0.5;

Shape shapeOf(uint slot) {
    vec3 x[4];
    vec3 low = vec3(1.0e30);
    vec3 high = vec3(-1.0e30);
    Shape shape;
    shape.insideCorners = 0u;
    shape.ended = true;
    shape.remaining = vec3(0.0);
    vec3 travel = vec3(0.0);
    vec3 leastShare = vec3(1.0);
    vec3 mostShare = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        Particle corner = patches[slot].corners[i];
        x[i] = corner.x;
        low = min(low, x[i]);
        high = max(high, x[i]);
        travel += corner.w;
        leastShare = min(leastShare, corner.meanShare);
        mostShare = max(mostShare, corner.meanShare);
        if (corner.status <= PARTICLE_INSIDE) {
            shape.ended = false;
            shape.remaining += 0.25 * remainingShare(corner);
        }
        shape.insideCorners += corner.status == PARTICLE_INSIDE ? 1u : 0u;
    }
    shape.sideU = max(distance(x[0], x[1]), distance(x[3], x[2]));
    shape.sideV = max(distance(x[0], x[3]), distance(x[1], x[2]));
    shape.nearDomain = all(lessThan(low, domain.max)) && all(greaterThan(high, domain.min));
    vec3 spread = mostShare - leastShare;
    shape.spread = max(spread.x, max(spread.y, spread.z));
    float section = crossSection(x[0], x[1], x[2], x[3], travel);  // its sign; travel is no unit vector
    shape.orientation = section > 0.0 ? 1u : (section < 0.0 ? 2u : 0u);
    return shape;
}

// Whether the patch has turned inside out in its last step; counts it.
bool folds(uint slot, uint orientation) {
    uint before = patches[slot].orientation;
    patches[slot].orientation = orientation != 0u ? orientation : before;
    bool folded = before != 0u && orientation != 0u && before != orientation;
    if (folded) {
        atomicAdd(queue.folds, 1u);
    }
    return folded;
}

LaunchRecord recordOf(uint slot, vec2 launchMin, vec2 launchMax) {
    LaunchRecord record;
    record.launchMin = launchMin;
    record.launchMax = launchMax;
    record.frameIndex = patches[slot].frameIndex;
    record.stepCount = patches[slot].stepCount;
    record.orientation = patches[slot].orientation;
    record.unusedA = 0u;
    return record;
}

// The pool is full: both halves wait as launch records. False if there is no room for them either.
bool keepAsRecords(LaunchRecord first, LaunchRecord second) {
    uint place = atomicAdd(queue.recordCount, 2u);
    if (place + 2u > settings.recordCapacity) {
        atomicAdd(queue.recordCount, 0xFFFFFFFEu);
        return false;
    }
    records[place] = first;
    records[place + 1u] = second;
    return true;
}

void halve(uint slot, bool alongU) {
    vec2 launchMin = patches[slot].launchMin;
    vec2 launchMax = patches[slot].launchMax;
    vec2 middle = 0.5 * (launchMin + launchMax);
    LaunchRecord first = recordOf(slot, launchMin, alongU ? vec2(middle.x, launchMax.y) : vec2(launchMax.x, middle.y));
    LaunchRecord second = recordOf(slot, alongU ? vec2(middle.x, launchMin.y) : vec2(launchMin.x, middle.y), launchMax);
    uint secondSlot;
    if (takeFreeSlot(secondSlot)) {
        listForSplit(slot, secondSlot, alongU);
        atomicAdd(queue.splits, 1u);
    } else if (keepAsRecords(first, second)) {
        returnSlot(slot);
        atomicAdd(queue.splits, 1u);
    } else {
        appendLive(slot);
        atomicAdd(queue.recordOverflow, 1u);
    }
}

float largestOf(vec3 value) {
    return max(value.x, max(value.y, value.z));
}

// Whether the patch is too long for its shape, or for the light across it, to be interpolated between its corners. Energy
// decides where that stops to matter.
bool wantsSplit(uint slot, Shape shape) {
    float side = max(shape.sideU, shape.sideV);
    bool tooLong = side > settings.maxSide;
    bool tooUneven = shape.spread > kMaxSpread * largestOf(shape.remaining) && side > kResolvedSide * settings.maxSide;
    return shape.nearDomain && (tooLong || tooUneven) &&
           largestOf(patches[slot].power * shape.remaining) > frames[patches[slot].frameIndex].splitPower;
}

void refine(uint slot, inout uint evaluations) {
    patches[slot].stepCount += 1u;
    Shape shape = shapeOf(slot);
    bool foldedAway = folds(slot, shape.orientation) && settings.foldsEnd != 0u;
    evaluations += shape.insideCorners;
    if (shape.ended || foldedAway || largestOf(shape.remaining) < settings.cullShare ||
        patches[slot].stepCount >= settings.maxSteps) {
        listForRetire(slot);
    } else if (wantsSplit(slot, shape)) {
        halve(slot, shape.sideU >= shape.sideV);
    } else {
        appendLive(slot);
    }
}

void main() {
    if (gl_LocalInvocationIndex == 0u) {
        groupEvaluations = 0u;
    }
    barrier();
    uint index = gl_GlobalInvocationID.x;
    if (index < queue.liveCount) {
        uint evaluations = 0u;
        refine(liveSlot(index), evaluations);
        atomicAdd(groupEvaluations, evaluations);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        countEvaluations(groupEvaluations);
    }
}

// Deposit of the 2007 method, for comparison: a patch offers its irradiance, power over the area that it covers, to the
// voxels that it passes, and a voxel keeps the largest offer and its direction (Tevs 2007, sections 4.2.4 and 6.2.3).
// Arrivals do not add up and offers have no bound at a focus: the grid does not hold the light's energy (docs/physics.md,
// section 3).
// Two passes, so that the result is the same in whatever order patches come: the first raises the irradiances, the second
// writes the directions of those that hold the largest. One program for both: their offers have to agree to the bit.
#include "lightsim/bake.glsl"
#include "shared/domain_block.h"
#include "lightsim/sweep.glsl"
#include "physics/tube.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

// Irradiances as the bits of a float: those of positive floats are in the same order as the floats.
layout(std430, binding = BAKE_PEAK_SUM_BINDING) buffer PeakSum { uint largestSum[]; };  // over bands
layout(std430, binding = BAKE_PEAK_DIRECTION_BINDING) buffer PeakDirection { uint directionOfLargest[]; };
#if BANDS == 3
layout(std430, binding = BAKE_IRRADIANCE_BINDING) buffer Peak0 { uint largest0[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 1) buffer Peak1 { uint largest1[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 2) buffer Peak2 { uint largest2[]; };
#endif

layout(std140, binding = BAKE_PEAK_PASS_BINDING) uniform PeakPassBlock {
    PeakPass peak;
};

// Points this far apart along each side, and half of it from the edges, leave out no voxel whose middle the patch passes:
// one of them is within sqrt(3)/4 of that middle [voxels].
const float kSpacing = 0.5;
const int kMaxPoints = 4;  // along each side: of two voxels, the longest that a tolerance allows
const float kLargestFinite = 3.0e38;

struct Offer {
    vec3 irradiance;
    vec3 direction;
};

uint sumBits(Offer offer) {
#if BANDS == 3
    return floatBitsToUint(min(offer.irradiance.x + offer.irradiance.y + offer.irradiance.z, kLargestFinite));
#else
    return floatBitsToUint(offer.irradiance.x);
#endif
}

uint directionWord(vec3 direction) {
    uvec3 steps = uvec3(ivec3(round(direction * float(PEAK_DIRECTION_STEPS))) + PEAK_DIRECTION_STEPS);
    return steps.x | (steps.y << 10) | (steps.z << 20);
}

void raise(uint index, Offer offer) {
    uint bits = sumBits(offer);
    if (atomicMax(largestSum[index], bits) < bits) {
        directionOfLargest[index] = 0u;  // it belonged to a smaller one; the next pass writes it anew
    }
#if BANDS == 3
    atomicMax(largest0[index], floatBitsToUint(offer.irradiance.x));
    atomicMax(largest1[index], floatBitsToUint(offer.irradiance.y));
    atomicMax(largest2[index], floatBitsToUint(offer.irradiance.z));
#endif
}

// Of several that are equally large, the one with the largest word.
void direct(uint index, Offer offer) {
    if (largestSum[index] == sumBits(offer)) {
        atomicMax(directionOfLargest[index], directionWord(offer.direction));
    }
}

void offerAt(vec3 x, Offer offer) {
    ivec3 voxel = ivec3(floor((x - domain.min) / domain.voxel));
    if (any(lessThan(voxel, ivec3(0, 0, settings.slabBegin))) ||
        any(greaterThanEqual(voxel, ivec3(domain.size.xy, settings.slabEnd)))) {
        return;
    }
    uint index = (uint(voxel.z - settings.slabBegin) * uint(domain.size.y) + uint(voxel.y)) * uint(domain.size.x) +
                 uint(voxel.x);
    if (peak.pass == PEAK_RAISE) {
        raise(index, offer);
    } else {
        direct(index, offer);
    }
}

int pointsFor(float lengthVoxels) {
    return clamp(int(ceil(lengthVoxels / kSpacing - 0.01)), 1, kMaxPoints);
}

// The patch as it was when a fraction of the step had passed. One that has turned inside out offers nothing.
void offerQuad(Sweep sweep, float fraction, vec3 power, vec3 direction, uint orientation) {
    vec3 x[4];
    for (int i = 0; i < 4; ++i) {
        x[i] = mix(sweep.before[i], sweep.after[i], fraction);
    }
    float section = crossSection(x[0], x[1], x[2], x[3], direction);
    float covered = coveredSection(x[0], x[1], x[2], x[3], direction);
    bool folded = (orientation == 1u && section < 0.0) || (orientation == 2u && section > 0.0);
    Offer offer;
    offer.irradiance = min(power * bilinear(sweep.share, vec2(0.5)) / max(covered, 1.0e-30), vec3(kLargestFinite));
    offer.direction = direction;
    if (folded || covered <= 0.0 || sumBits(offer) == 0u) {
        return;
    }
    ivec2 counts = ivec2(pointsFor(sideAlongU(sweep) / domain.voxel), pointsFor(sideAlongV(sweep) / domain.voxel));
    for (int i = 0; i < counts.x * counts.y; ++i) {
        offerAt(bilinear(x, (vec2(float(i % counts.x), float(i / counts.x)) + 0.5) / vec2(counts)), offer);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= queue.liveCount) {
        return;
    }
    uint slot = liveSlot(index);
    Sweep sweep = sweepOf(slot);
    vec3 travel = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        travel += patches[slot].corners[i].w;
    }
    vec3 direction = travel / max(length(travel), 1.0e-30);
    int counts = pointsFor(longestStepVoxels(sweep));
    for (int i = 0; i < counts; ++i) {
        offerQuad(sweep, (float(i) + 0.5) / float(counts), patches[slot].power, direction, patches[slot].orientation);
    }
}

// How far the ray in the middle of something is from what its neighbours let expect, sample by sample.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/launch_power.glsl"

layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };

#include "lightsim/tubes/opaque_front.glsl"

struct Expectation {
    vec3 position;
    vec3 share;
    vec3 along;       // from one neighbour to the other [scene units]; 0: no matter
    float evenShift;  // of the middle along it if irradiance is the same on both sides, over its length
    float extent;     // distance between the neighbours [scene units]
    float firstEnd;   // where the first of all ends, in steps of the window, if all end at one surface; else kNoEnd
};

// Whether a sample belongs to a ray that light has come along, not to its image before a mirror.
bool isReal(uint place) {
#ifdef FOLLOW_REFLECTIONS
    return shareAt(place).w >= 0.0;
#else
    return true;
#endif
}

// How unevenly rays are spread between two neighbours, as the shift of the middle along the line between them over its length:
// that is by how much irradiance changes between them. It does not matter within a voxel, and a front that is curved alike
// everywhere is even.
float unevenShift(vec3 deviation, Expectation expected) {
    float extent2 = dot(expected.along, expected.along);
    float shift = dot(deviation, expected.along) - expected.evenShift * extent2;
    return extent2 > tube.evenSide * tube.evenSide ? abs(shift) / extent2 : 0.0;
}

// By how much the light left differs from what neighbours say, relative.
float shareError(vec3 share, Expectation expected) {
    float larger = largestOf(max(share, expected.share));
    return expected.extent > tube.resolvedSide ? largestOf(abs(share - expected.share)) / max(larger, 1.0e-30) : 0.0;
}

// How much of the power about a middle its neighbours put into the wrong places, if it is off by that: all of it, if what is
// between the neighbours is voxels away, three times as dense on one side of the middle as on the other, or a seventeenth of its
// light is not known. If it took more shift, voxels would be no worse on the whole, but single ones where sheets cross by 2 %; if
// it took a fifth of the light, rays would be a twentieth fewer, and sums over rays, the ledger that the grid is judged by among
// them, off by up to a per cent.
float misplacedPart(float deviation, float shift, float shareError) {
    const float kAllDeviation = 3.0;  // [voxels]
    const float kAllShift = 0.25;
    const float kAllShareError = 0.06;
    return min(1.0, max(max(deviation / (kAllDeviation * domain.voxel), shift / kAllShift), shareError / kAllShareError));
}

// Whether anything that is off may be halved: with less power than that, nothing is.
bool isWorthHalving(vec3 power, uint frameIndex) {
    return largestOf(power) > frames[frameIndex].splitPower;
}

#ifdef FIELD_DETAIL
#include "shared/bindings.h"
#include "shared/brick.h"

layout(binding = kUnitDetail) uniform sampler3D detailGrid;

// Whether the rectangles beside an edge with its middle at x may hold detail that their rays pass unseen: the edge is longer than
// that allows, and the fields hold some within its length. `along`: the edge [scene units].
bool mayHide(vec3 x, vec3 along) {
    const float kSeen = 2.0;  // by rays with another halfway [voxels]
    vec3 extent = abs(along) / domain.voxel;
    ivec3 brick = ivec3(floor((x - domain.min) / (float(kBrickVoxels) * domain.voxel)));
    brick = clamp(brick, ivec3(0), textureSize(detailGrid, 0) - 1);
    float bricks = round(255.0 * texelFetch(detailGrid, brick, 0).r);
    return length(extent) > kSeen && largestOf(extent) > (bricks - 1.0) * float(kBrickVoxels);
}
#else
bool mayHide(vec3 x, vec3 along) {
    return false;
}
#endif

// Adds what sample k of a middle's track says; `power`: the power about it, by band, before losses. Errors are spread evenly over
// what is halved: the power that a halving puts right, not how far off a ray is, decides whether it is worth its rays.
void measureSample(uint middle, int k, Expectation expected, vec3 power, inout TubeMeasure measure) {
    uint place = trackOf(middle) + uint(k);
    vec3 share = shareAt(place).rgb;
    vec3 offset = positionAt(place).xyz - expected.position;
    float deviation = length(offset);
    float shift = unevenShift(offset, expected);
    float error = float(k) > expected.firstEnd ? 0.0 : shareError(share, expected);
    const float kHiddenPart = 0.1;  // of the power, if there is detail and it does what middles do not tell
    bool hides = mayHide(positionAt(place).xyz, expected.along);
    if (hides || deviation > tube.maxDeviation || shift > tube.maxUnevenSpread || error > tube.maxShareDeviation) {
        float part = max(hides ? kHiddenPart : 0.0, misplacedPart(deviation, shift, error));
        if (isWorthHalving(part * power * max(share, expected.share), vertices[middle].frameIndex)) {
            measure.strong |= sampleBit(k);
        } else {
            measure.weak |= sampleBit(k);
        }
    }
}

// How far the ray in the middle of something is from what its neighbours let expect, sample by sample.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/launch_power.glsl"

layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };

struct Expectation {
    vec3 position;
    vec3 share;
    vec3 along;       // from one neighbour to the other [scene units]; 0: no matter
    float evenShift;  // of the middle along it if irradiance is the same on both sides, over its length
    float extent;     // distance between the neighbours [scene units]
};

// Whether a sample belongs to a ray that light has come along, not to its image before a mirror.
bool isReal(uint place) {
#ifdef FOLLOW_REFLECTIONS
    return shares[place].w >= 0.0;
#else
    return true;
#endif
}

// Whether rays are spread unevenly between two neighbours: that is by how much irradiance changes between them. It does not
// matter within a voxel, and a front that is curved alike everywhere is even.
bool isUneven(vec3 deviation, Expectation expected) {
    float extent2 = dot(expected.along, expected.along);
    float shift = dot(deviation, expected.along) - expected.evenShift * extent2;
    return extent2 > tube.evenSide * tube.evenSide && abs(shift) > tube.maxUnevenSpread * extent2;
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

// Adds what sample k of a middle's track says; `power`: the power about it, by band, before losses.
void measureSample(uint middle, int k, Expectation expected, vec3 power, inout TubeMeasure measure) {
    uint place = trackOf(middle) + uint(k);
    vec3 share = shares[place].rgb;
    vec3 larger = max(share, expected.share);
    vec3 deviation = positions[place].xyz - expected.position;
    bool bent = length(deviation) > tube.maxDeviation || isUneven(deviation, expected);
    bool uneven = largestOf(abs(share - expected.share)) > tube.maxShareDeviation * largestOf(larger) &&
                  expected.extent > tube.resolvedSide;
    if (bent || uneven || mayHide(positions[place].xyz, expected.along)) {
        if (largestOf(power * larger) > frames[vertices[middle].frameIndex].splitPower) {
            measure.strong |= sampleBit(k);
        } else {
            measure.weak |= sampleBit(k);
        }
    }
}

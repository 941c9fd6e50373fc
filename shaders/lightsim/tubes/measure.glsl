// How far the ray in the middle of something is from what its neighbours let expect, sample by sample.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/launch_power.glsl"

layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };

struct Expectation {
    vec3 position;
    vec3 share;
    float extent;  // distance between the neighbours [scene units]
};

// Adds what sample k of a middle's track says; `power`: the power about it, by band, before losses.
void measureSample(uint middle, int k, Expectation expected, vec3 power, inout TubeMeasure measure) {
    uint place = trackOf(middle) + uint(k);
    vec3 share = shares[place].rgb;
    vec3 larger = max(share, expected.share);
    bool bent = distance(positions[place].xyz, expected.position) > tube.maxDeviation;
    bool uneven = largestOf(abs(share - expected.share)) > tube.maxShareDeviation * largestOf(larger) &&
                  expected.extent > tube.resolvedSide;
    if (bent || uneven) {
        if (largestOf(power * larger) > frames[vertices[middle].frameIndex].splitPower) {
            measure.strong |= sampleBit(k);
        } else {
            measure.weak |= sampleBit(k);
        }
    }
}

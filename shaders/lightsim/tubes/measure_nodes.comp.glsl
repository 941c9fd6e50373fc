// Measure, of nodes: is the ray in the centre where the eight about it say (Coons's patch)? And the power of the sub-cells.
#include "lightsim/tubes/measure.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { uint listed[]; };
layout(std430, binding = TUBE_RESULTS_BINDING) writeonly buffer ResultBlock { TubeMeasure measures[]; };
layout(std430, binding = TUBE_NODES_BINDING) buffer NodeBlock { TubeNode nodes[]; };

const uint kCentre = 4u;

vec4 launchSharesOf(TubeNode node, LaunchFrame frame) {
    vec4 launchShare;
    for (int i = 0; i < 4; ++i) {
        int low = i % 2 + 3 * (i / 2);
        launchShare[i] = launchShareOfStrength(frame, vertices[node.vertices[low]].launch,
                                               vertices[node.vertices[low + 4]].launch);
    }
    return launchShare;
}

// Half the sum of the sides' middles less a quarter of the corners'.
Expectation expectedCentre(TubeNode node, int k, float firstEnd) {
    Expectation expected = Expectation(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 0.0, firstEnd);
    for (uint i = 0u; i < 9u; ++i) {
        if (i != kCentre) {
            float weight = i % 2u == 1u ? 0.5 : -0.25;
            uint place = trackOf(node.vertices[i]) + uint(k);
            expected.position += weight * positionAt(place).xyz;
            expected.share += weight * shareAt(place).rgb;
        }
    }
    expected.extent = distance(positionAt(trackOf(node.vertices[1]) + uint(k)).xyz,
                               positionAt(trackOf(node.vertices[7]) + uint(k)).xyz);
    return expected;
}

// Where the first of the nine ends, if all end at one surface.
float firstEndOf(TubeNode node) {
    float centre = endOf(node.vertices[kCentre]);
    float first = centre;
    float expected = 0.0;
    for (uint i = 0u; i < 9u; ++i) {
        if (i != kCentre) {
            float end = endOf(node.vertices[i]);
            expected += (i % 2u == 1u ? 0.5 : -0.25) * end;
            first = min(first, end);
            centre = max(centre, end > 0.5 * kNoEnd ? kNoEnd : centre);
        }
    }
    return isOneSurface(centre, expected) ? first : kNoEnd;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    uint self = listed[index];
    TubeNode node = nodes[self];
    LaunchFrame frame = frames[node.frameIndex];
    vec4 launchShare = launchSharesOf(node, frame);
    vec3 power = frame.strength * dot(launchShare, vec4(1.0));
    bool isMeasured = isWorthHalving(power, node.frameIndex);
    float firstEnd = firstEndOf(node);
    TubeMeasure measure = TubeMeasure(uvec2(0u), uvec2(isMeasured ? 0u : ~0u), launchShare);
    for (int k = 0; k < (isMeasured ? TUBE_SAMPLES : 0); ++k) {
        uint centre = trackOf(node.vertices[kCentre]) + uint(k);
        if (withinDomain(positionAt(centre).xyz, domain.voxel) && isReal(centre)) {
            measureSample(node.vertices[kCentre], k, expectedCentre(node, k, firstEnd), power, measure);
        }
    }
    nodes[self].launchShare = launchShare;
    measures[index] = measure;
}

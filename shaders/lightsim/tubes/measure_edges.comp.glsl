// Measure, of edges: is the ray in the middle halfway between the ends? Both rectangles beside the edge get this one answer.
#include "lightsim/tubes/measure.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { TubeEdge edges[]; };
layout(std430, binding = TUBE_RESULTS_BINDING) writeonly buffer ResultBlock { TubeMeasure measures[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    TubeEdge edge = edges[index];
    uint frameIndex = vertices[edge.middle].frameIndex;
    LaunchFrame frame = frames[frameIndex];
    float side = largestOf(abs(vec3(vertices[edge.second].launch - vertices[edge.first].launch, 0.0)));
    vec3 power = frame.strength * (launchDensity(frame, vertices[edge.middle].launch) * side * side);
    // On the plane of a point light's frame rays lie further apart, by the square of the cosine in one direction, where power
    // is thinner by its cube; between the quarters of the edge.
    float spacing = pow(launchDensity(frame, vertices[edge.first].launch) / launchDensity(frame, vertices[edge.second].launch),
                        1.0 / 3.0);
    float evenShift = 0.5 * (spacing - 1.0) / (spacing + 1.0);
    float ends[2] = float[2](endOf(edge.first), endOf(edge.second));
    bool oneSurface = isOneSurface(endOf(edge.middle), 0.5 * (ends[0] + ends[1]));
    float firstEnd = oneSurface ? min(endOf(edge.middle), min(ends[0], ends[1])) : kNoEnd;
    TubeMeasure measure = TubeMeasure(uvec2(0u), uvec2(0u), vec4(0.0));
    for (int k = 0; k < (isWorthHalving(power, frameIndex) ? TUBE_SAMPLES : 0); ++k) {
        uint first = trackOf(edge.first) + uint(k);
        uint second = trackOf(edge.second) + uint(k);
        uint middle = trackOf(edge.middle) + uint(k);
        vec3 a = positionAt(first).xyz;
        vec3 b = positionAt(second).xyz;
        bool isInside = withinDomain(a, domain.voxel) || withinDomain(b, domain.voxel) ||
                        withinDomain(positionAt(middle).xyz, domain.voxel);
        if (isInside && (isReal(first) || isReal(second) || isReal(middle))) {
            Expectation expected = Expectation(0.5 * (a + b), 0.5 * (shareAt(first).rgb + shareAt(second).rgb),
                                               b - a, evenShift, distance(a, b), firstEnd);
            measureSample(edge.middle, k, expected, power, measure);
        }
    }
    measures[index] = measure;
}

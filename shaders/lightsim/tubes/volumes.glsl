// How thin the light is spread at the corners of a cell, to second order.
// The volume of the cell's own map is constant along its sides but for their change of length: a first-order guess, with
// jumps between cells. Quadratics through the three vertices of each row of the node give derivatives that agree from cell
// to cell; scaled so that the cell holds its power all the same.
#include "lightsim/launch_power.glsl"

layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };

// Derivative per sub-cell at place `at` of the parabola through values at 0, 1, 2.
vec3 derivativeAt(uint at, vec3 x0, vec3 x1, vec3 x2) {
    return (float(2u * at) - 1.0) * 0.5 * (x0 - 2.0 * x1 + x2) + x1 - x0;
}

// The vertices of a node at a sample, row by row [voxels].
struct NodeFront {
    vec3 x[9];
};

NodeFront frontOf(TubeNode node, uint k) {
    NodeFront front;
    for (int i = 0; i < 9; ++i) {
        front.x[i] = (positionAt(trackOf(node.vertices[i]) + k).xyz - domain.min) / domain.voxel;
    }
    return front;
}

// Area per sub-cell at a vertex of the node, as a vector across it.
vec3 areaAt(NodeFront front, uint column, uint row) {
    vec3 alongU = derivativeAt(column, front.x[3u * row], front.x[3u * row + 1u], front.x[3u * row + 2u]);
    vec3 alongV = derivativeAt(row, front.x[column], front.x[column + 3u], front.x[column + 6u]);
    return cross(alongU, alongV);
}

// Power at a vertex over the mean of the sub-cell.
float relativePower(TubeNode node, LaunchFrame frame, uint column, uint row, uint quarter) {
    vec2 extent = vertices[node.vertices[4]].launch - vertices[node.vertices[0]].launch;
    float density = launchDensity(frame, vertices[node.vertices[column + 3u * row]].launch);
    return density * extent.x * extent.y / max(node.launchShare[quarter], 1.0e-30);
}

// `map`: of the sub-cell that is the quarter of a node between two samples.
vec4[2] volumesOf(TubeNode node, Trilinear map, uint quarter, NodeFront before, NodeFront after) {
    const float kTrusted = 1.1;  // ratio to the cell's own volume beyond which the map is too rough for quadratics
    LaunchFrame frame = frames[node.frameIndex];
    float smoothed[8];
    float meanRatio = 0.0;
    bool trusted = true;
    for (uint i = 0u; i < 4u; ++i) {
        uint column = quarter % 2u + i % 2u;
        uint row = quarter / 2u + i / 2u;
        vec3 corner = vec3(float(i % 2u), float(i / 2u), 0.0);
        vec3 travel = after.x[column + 3u * row] - before.x[column + 3u * row];
        float power = relativePower(node, frame, column, row, quarter);
        smoothed[i] = dot(areaAt(before, column, row), travel) / power;
        smoothed[i + 4u] = dot(areaAt(after, column, row), travel) / power;
        vec2 ratio = vec2(determinant(derivativesIn(map, corner)) / smoothed[i],
                          determinant(derivativesIn(map, corner + vec3(0.0, 0.0, 1.0))) / smoothed[i + 4u]);
        trusted = trusted && all(greaterThan(ratio, vec2(1.0 / kTrusted))) && all(lessThan(ratio, vec2(kTrusted)));
        meanRatio += 0.125 * (ratio.x + ratio.y);
    }
    vec4 volumes[2];
    for (int i = 0; i < 8; ++i) {
        volumes[i / 4][i % 4] = trusted ? sqrt(abs(smoothed[i] * meanRatio)) : TUBE_OWN_VOLUME;
    }
    return volumes;
}

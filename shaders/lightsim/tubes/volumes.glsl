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

vec3 vertexPosition(TubeNode node, uint column, uint row, uint k) {
    return positions[trackOf(node.vertices[column + 3u * row]) + k].xyz / domainVoxel;
}

// Signed area per sub-cell across the direction `along` at a vertex of the node.
vec3 areaAt(TubeNode node, uint column, uint row, uint k) {
    vec3 alongU = derivativeAt(column, vertexPosition(node, 0u, row, k), vertexPosition(node, 1u, row, k),
                               vertexPosition(node, 2u, row, k));
    vec3 alongV = derivativeAt(row, vertexPosition(node, column, 0u, k), vertexPosition(node, column, 1u, k),
                               vertexPosition(node, column, 2u, k));
    return cross(alongU, alongV);
}

// Power at a vertex over the mean of the sub-cell.
float relativePower(TubeNode node, uint column, uint row, uint quarter) {
    LaunchFrame frame = frames[node.frameIndex];
    vec2 extent = vertices[node.vertices[4]].launch - vertices[node.vertices[0]].launch;
    float density = launchDensity(frame, vertices[node.vertices[column + 3u * row]].launch);
    return density * extent.x * extent.y / max(node.launchShare[quarter], 1.0e-30);
}

vec4[2] volumesOf(TubeNode node, TubeCell cell, uint quarter, uint first, uint last) {
    const float kTrusted = 1.1;  // ratio to the cell's own volume beyond which the map is too rough for quadratics
    vec3 x[8];
    for (int i = 0; i < 8; ++i) {
        x[i] = cell.corners[i].xyz;
    }
    Trilinear map = trilinearOf(x);
    float smoothed[8];
    float meanRatio = 0.0;
    bool trusted = true;
    for (int i = 0; i < 8; ++i) {
        uint column = quarter % 2u + uint(i) % 2u;
        uint row = quarter / 2u + uint(i) / 2u % 2u;
        vec3 travel = x[i % 4 + 4] - x[i % 4];
        float own = determinant(derivativesIn(map, vec3(ivec3(i & 1, i >> 1 & 1, i >> 2))));
        smoothed[i] = dot(areaAt(node, column, row, i < 4 ? first : last), travel) / relativePower(node, column, row, quarter);
        float ratio = own / smoothed[i];
        trusted = trusted && ratio > 1.0 / kTrusted && ratio < kTrusted;
        meanRatio += 0.125 * ratio;
    }
    vec4 volumes[2];
    for (int i = 0; i < 8; ++i) {
        volumes[i / 4][i % 4] = trusted ? sqrt(abs(smoothed[i] * meanRatio)) : TUBE_OWN_VOLUME;
    }
    return volumes;
}

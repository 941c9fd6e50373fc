// A cubic B-spline of one grid, and its own gradient. Texel (i, j, k) holds the coefficients i to i + 3 of a row, so that
// sixteen fetches bring all 64, exact whatever the weights of the texture unit; no loops, of which a dispatch has few. Sums
// are of differences from one of the coefficients, `base`: slopes would else be lost in the rounding of n.
#include "physics/spline.glsl"

// Of a row: value, d/dx.
vec2 splineRow(sampler3D rows, ivec3 at, float base, vec4 weightsX, vec4 slopesX) {
    vec4 coefficients = texelFetch(rows, at, 0) - base;
    return vec2(dot(coefficients, weightsX), dot(coefficients, slopesX));
}

// Of four rows above each other: value, d/dx, d/dy.
vec3 splinePlane(sampler3D rows, ivec3 at, float base, vec4 weightsX, vec4 slopesX, vec4 weightsY, vec4 slopesY) {
    vec2 a = splineRow(rows, at, base, weightsX, slopesX);
    vec2 b = splineRow(rows, at + ivec3(0, 1, 0), base, weightsX, slopesX);
    vec2 c = splineRow(rows, at + ivec3(0, 2, 0), base, weightsX, slopesX);
    vec2 d = splineRow(rows, at + ivec3(0, 3, 0), base, weightsX, slopesX);
    vec4 values = vec4(a.x, b.x, c.x, d.x);
    return vec3(dot(values, weightsY), dot(vec4(a.y, b.y, c.y, d.y), weightsY), dot(values, slopesY));
}

// Gradient by voxel in rgb, value in alpha; t: place, 0 to 1, between the second and the third coefficient of each axis.
vec4 sampleSpline(sampler3D rows, ivec3 first, vec3 t) {
    vec4 weightsX = splineWeights(t.x), slopesX = splineSlopes(t.x);
    vec4 weightsY = splineWeights(t.y), slopesY = splineSlopes(t.y);
    vec4 weightsZ = splineWeights(t.z), slopesZ = splineSlopes(t.z);
    float base = texelFetch(rows, first + ivec3(0, 1, 1), 0).y;
    vec3 a = splinePlane(rows, first, base, weightsX, slopesX, weightsY, slopesY);
    vec3 b = splinePlane(rows, first + ivec3(0, 0, 1), base, weightsX, slopesX, weightsY, slopesY);
    vec3 c = splinePlane(rows, first + ivec3(0, 0, 2), base, weightsX, slopesX, weightsY, slopesY);
    vec3 d = splinePlane(rows, first + ivec3(0, 0, 3), base, weightsX, slopesX, weightsY, slopesY);
    vec4 values = vec4(a.x, b.x, c.x, d.x);
    return vec4(dot(vec4(a.y, b.y, c.y, d.y), weightsZ), dot(vec4(a.z, b.z, c.z, d.z), weightsZ),
                dot(values, slopesZ), base + dot(values, weightsZ));
}

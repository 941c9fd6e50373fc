// Trilinear value of a grid at a texture coordinate (0 to 1 from face to face), clamped at the faces.

#ifdef MANUAL_FILTERING

// By hand, for texture units that weight with fewer bits than a float has.
vec4 sampleTrilinear(sampler3D grid, vec3 coordinate) {
    ivec3 size = textureSize(grid, 0);
    vec3 position = coordinate * vec3(size) - 0.5;
    vec3 base = floor(position);
    vec3 t = position - base;
    ivec3 lo = clamp(ivec3(base), ivec3(0), size - 1);
    ivec3 hi = clamp(ivec3(base) + 1, ivec3(0), size - 1);
    vec4 x00 = mix(texelFetch(grid, ivec3(lo.x, lo.y, lo.z), 0), texelFetch(grid, ivec3(hi.x, lo.y, lo.z), 0), t.x);
    vec4 x10 = mix(texelFetch(grid, ivec3(lo.x, hi.y, lo.z), 0), texelFetch(grid, ivec3(hi.x, hi.y, lo.z), 0), t.x);
    vec4 x01 = mix(texelFetch(grid, ivec3(lo.x, lo.y, hi.z), 0), texelFetch(grid, ivec3(hi.x, lo.y, hi.z), 0), t.x);
    vec4 x11 = mix(texelFetch(grid, ivec3(lo.x, hi.y, hi.z), 0), texelFetch(grid, ivec3(hi.x, hi.y, hi.z), 0), t.x);
    return mix(mix(x00, x10, t.y), mix(x01, x11, t.y), t.z);
}

#else

vec4 sampleTrilinear(sampler3D grid, vec3 coordinate) {
    return textureLod(grid, coordinate, 0.0);
}

#endif

// Places on the lens: a low-discrepancy sequence, shifted by pixel, so that what is out of focus shows fine noise and no
// copies of edges.

// PCG3D (M. Jarzynski, M. Olano, Hash Functions for GPU Rendering, 2020).
uvec3 hashed(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

vec2 lensPlace(ivec2 pixel) {
    vec2 shift = vec2(hashed(uvec3(pixel, view.lensHalf)).xy >> 8u) / 16777216.0;
    return view.lensRadius * discPlace(fract(view.lensSequence + shift));
}

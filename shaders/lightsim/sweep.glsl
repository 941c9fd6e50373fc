// What a patch sweeps in its last step: bilinear over the patch, linear along the step.

struct Sweep {
    vec3 before[4];
    vec3 after[4];
    vec3 share[4];
    vec4 lengths;  // of the corners' steps along their arcs [voxels]: the path length even where they bend or part
};

Sweep sweepOf(uint slot) {
    Sweep sweep;
    for (int i = 0; i < 4; ++i) {
        sweep.before[i] = patches[slot].corners[i].xPrevious;
        sweep.after[i] = patches[slot].corners[i].x;
        sweep.share[i] = patches[slot].corners[i].meanShare;
        sweep.lengths[i] = patches[slot].corners[i].arcLength / domain.voxel;
    }
    return sweep;
}

vec3 bilinear(vec3 corners[4], vec2 at) {
    return mix(mix(corners[0], corners[1], at.x), mix(corners[3], corners[2], at.x), at.y);
}

float bilinear(vec4 corners, vec2 at) {
    return mix(mix(corners.x, corners.y, at.x), mix(corners.w, corners.z, at.x), at.y);
}

float longerOf(Sweep sweep, int a, int b, int c, int d) {
    return max(distance(sweep.after[a], sweep.after[b]), distance(sweep.after[c], sweep.after[d]));
}

float sideAlongU(Sweep sweep) {
    return longerOf(sweep, 0, 1, 3, 2);
}

float sideAlongV(Sweep sweep) {
    return longerOf(sweep, 0, 3, 1, 2);
}

float longestStepVoxels(Sweep sweep) {
    return max(max(sweep.lengths.x, sweep.lengths.y), max(sweep.lengths.z, sweep.lengths.w));
}

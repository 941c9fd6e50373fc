// Depth in matter: 1/2 less the distance to its surface [voxels], positive inside. From 0 to 1 it is the share of a voxel's cube
// that matter takes; beyond it goes on, so that between voxels it is linear about a flat surface, however that lies to them.

real shareOfDepth(real depth) {
    return clamp(depth, 0.0, 1.0);
}

// Depth in either of two bodies, given the cosine between the gradients of both. Of two that face the same way one lies in the
// other; of two that face each other, as on both sides of a seam, each has a part of the voxel of its own; others are between.
real joinedDepth(real a, real b, real cosine) {
    real more = max(a, b);
    real less = min(a, b);
    return max(more, min(more + 0.5 * (1.0 - cosine) * shareOfDepth(less), 1.0));
}

// The outward normal of opaque matter from its depth (physics/depth.glsl; docs/physics.md, section 5), by differences under a
// kernel that is round, two voxels wide. Where depth is linear about the surface any differences are exact. Where it is known by
// shares of voxels alone it rises over about a voxel: differences along three axes then see the voxels, and are 6 degrees off;
// these are off by 1.
// Whoever includes this says what `real depthAt(real3 x)` is.

// About x, in no unit.
real3 depthGradient(real3 x, real voxel) {
    real3 gradient = real3(0.0, 0.0, 0.0);
    for (int i = 0; i < 27; ++i) {
        real3 offset = real3(real(i % 3 - 1), real(i / 3 % 3 - 1), real(i / 9 - 1));
        real within = 1.0 - 0.25 * dot(offset, offset);
        gradient += offset * (within * within * depthAt(x + offset * voxel));
    }
    return gradient;
}

// At the end x of a ray of unit direction. Where that lies inside, on a cut face of the matter, it is towards the eye.
real3 outwardNormal(real3 x, real voxel, real3 direction) {
    const real kInside = 1.0;  // half a voxel deep
    real3 gradient = depthGradient(x, voxel);
    real magnitude = length(gradient);
    return depthAt(x) < kInside && magnitude > 1.0e-4 ? -gradient / magnitude : -direction;
}

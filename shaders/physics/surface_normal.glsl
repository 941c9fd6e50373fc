// The outward normal of opaque matter from its coverage by area, which rises over about a voxel (docs/physics.md, section 5).
// Differences along three axes see the voxels, and are 6 degrees off; under a kernel that is round, two voxels wide, the gradient
// is off by 0.8.
// Whoever includes this says what `real coverageAt(real3 x)` is.

// About x, in no unit; 0 where the matter is cut.
real3 coverageGradient(real3 x, real voxel) {
    real3 gradient = real3(0.0, 0.0, 0.0);
    for (int i = 0; i < 27; ++i) {
        real3 offset = real3(real(i % 3 - 1), real(i / 3 % 3 - 1), real(i / 9 - 1));
        real within = 1.0 - 0.25 * dot(offset, offset);
        gradient += offset * (within * within * coverageAt(x + offset * voxel));
    }
    return gradient;
}

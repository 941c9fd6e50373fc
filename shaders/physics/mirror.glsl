// What a smoothed boundary mirrors (docs/physics.md, section 4). The mirror is the surface on which the index is the mean of
// both sides': there it changes most. Beyond the boundary the reflected ray is the image of the one that came, in the axis across
// the mirror where that met it: exactly so where the boundary is alike all round this axis, as planes and spheres are. Its way
// through the half of the boundary that the ray came by is not taken again, which at flat angles no step is short enough for.
// Whoever includes this says what `Optics sampleOptics(real3 x)` is, as for physics/step_leapfrog.glsl.

// Newton steps to the mirror from the steepest sample, at most half a step away: the first leaves 0.01 voxel, where the
// index has no curvature, the second 0.0001.
const int kMirrorCorrections = 2;

// A ray near the place where the index is `level`, followed there; no step of it goes farther than `longest`.
Ray rayAtIndex(Ray near, real level, real longest) {
    Ray at = near;
    for (int i = 0; i < kMirrorCorrections; ++i) {
        Optics there = sampleOptics(at.x);
        real slope = dot(there.gradN, at.w) / length(at.w);
        real ds = slope != 0.0 ? clamp((level - there.n) / slope, -longest, longest) : 0.0;
        at = stepLeapfrog(at, ds).ray;
    }
    return at;
}

// The image of a ray, which was at `start` before the boundary, that met the mirror at a place with grad n.
Ray rayMirrored(Ray start, real3 onMirror, real3 gradN) {
    real3 normal = gradN / max(length(gradN), 1.0e-30);
    real3 back = start.x - onMirror;
    real across = 2.0 * dot(back, normal), turned = 2.0 * dot(start.w, normal);
    Ray image;
    image.x = onMirror - back + normal * across;
    image.w = start.w - normal * turned;
    return image;
}

// The same of a ray that leaves in another direction, as from a facet: it sets out as far before the mirror.
Ray rayLeaving(Ray start, real3 onMirror, real3 gradN, real3 away) {
    real3 normal = gradN / max(length(gradN), 1.0e-30);
    Ray leaving;
    leaving.x = onMirror + normal * dot(start.x - onMirror, normal);
    leaving.w = away;
    return leaving;
}

// What a smoothed boundary mirrors (docs/physics.md, section 4). The mirror is the surface on which the index is the mean of
// both sides': there it changes most. A ray turns round on it and goes out through the half of the boundary that it came in by,
// bent as on its way in, so that the law of reflection holds beyond it.
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

// A ray on the mirror that leaves the boundary, on the side that it came from, with wave vector `away` beyond it.
Ray rayLeaving(Ray ray, real3 away, real3 gradN) {
    real3 normal = gradN / max(length(gradN), 1.0e-30);
    real across = dot(away, normal);
    real3 along = away - normal * across;
    // From glass at a flat angle there is none: the flattest that there is.
    real most = 0.999 * length(ray.w);
    along = along * min(most / max(length(along), 1.0e-30), 1.0);
    real rest = sqrt(dot(ray.w, ray.w) - dot(along, along));
    Ray leaving = ray;
    leaving.w = along + normal * (across >= 0.0 ? rest : -rest);
    return leaving;
}

// The ray turned round on a surface across gradN.
Ray rayMirrored(Ray ray, real3 gradN) {
    Ray turned = ray;
    turned.w = ray.w - gradN * (2.0 * dot(ray.w, gradN) / max(dot(gradN, gradN), 1.0e-30));
    return turned;
}

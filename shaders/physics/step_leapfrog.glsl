// Leapfrog (drift, kick, drift) by arc length: symplectic, second order; one evaluation, in the middle.

RayStep stepLeapfrog(Ray ray, real ds) {
    Ray middle = driftByLength(ray, 0.5 * ds);
    Optics there = sampleOptics(middle.x);
    RayStep taken;
    taken.ray = driftByLength(kickByLength(middle, there.gradN, ds), 0.5 * ds);
    taken.opticalLength = there.n * ds;
    taken.looked = kickByLength(middle, there.gradN, 0.5 * ds);
    taken.n = there.n;
    taken.gradN = there.gradN;
    return taken;
}

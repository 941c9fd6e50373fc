// Leapfrog (drift, kick, drift) by arc length: symplectic, second order; one evaluation, in the middle.

// `perW`: 1 / |w|, which whoever takes step after step has from the one before.
RayStep stepLeapfrogOnward(Ray ray, real perW, real ds) {
    Ray middle = driftAlong(ray, perW, 0.5 * ds);
    Optics there = sampleOptics(middle.x);
    Ray turned = kickByLength(middle, there.gradN, ds);
    RayStep taken;
    taken.perW = 1.0 / length(turned.w);
    taken.ray = driftAlong(turned, taken.perW, 0.5 * ds);
    taken.opticalLength = there.n * ds;
    taken.looked = kickByLength(middle, there.gradN, 0.5 * ds);
    taken.n = there.n;
    taken.gradN = there.gradN;
    return taken;
}

RayStep stepLeapfrog(Ray ray, real ds) {
    return stepLeapfrogOnward(ray, 1.0 / length(ray.w), ds);
}

// Euler's method, as in 2007: dx/ds = w/n, dw/ds = grad n, both where the step begins. First order; one evaluation.

RayStep stepEuler(Ray ray, real ds) {
    Optics start = sampleOptics(ray.x);
    RayStep taken;
    taken.ray.x = ray.x + ray.w * (ds / start.n);
    taken.ray.w = ray.w + start.gradN * ds;
    taken.perW = 1.0 / length(taken.ray.w);
    taken.opticalLength = start.n * ds;
    taken.looked = ray;
    taken.n = start.n;
    taken.gradN = start.gradN;
    return taken;
}

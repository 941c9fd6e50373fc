// The classical Runge-Kutta method on dx/ds = w/|w|, dw/ds = grad n: fourth order; four evaluations.

RayStep stepRk4(Ray ray, real ds) {
    Optics a = sampleOptics(ray.x);
    real3 wa = ray.w;
    Ray second = kickByLength(driftByLength(ray, 0.5 * ds), a.gradN, 0.5 * ds);
    Optics b = sampleOptics(second.x);
    Ray third = ray;
    third.x = ray.x + second.w * (0.5 * ds / length(second.w));
    third.w = ray.w + b.gradN * (0.5 * ds);
    Optics c = sampleOptics(third.x);
    Ray fourth = ray;
    fourth.x = ray.x + third.w * (ds / length(third.w));
    fourth.w = ray.w + c.gradN * ds;
    Optics d = sampleOptics(fourth.x);
    real3 velocities = wa / length(wa) + 2.0 * (second.w / length(second.w) + third.w / length(third.w)) +
                       fourth.w / length(fourth.w);
    RayStep taken;
    taken.ray.x = ray.x + velocities * (ds / 6.0);
    taken.ray.w = ray.w + (a.gradN + 2.0 * (b.gradN + c.gradN) + d.gradN) * (ds / 6.0);
    taken.perW = 1.0 / length(taken.ray.w);
    taken.opticalLength = (a.n + 2.0 * (b.n + c.n) + d.n) * (ds / 6.0);
    taken.looked = third;
    taken.n = c.n;
    taken.gradN = c.gradN;
    return taken;
}

// A. Sharma, D. Vizia Kumar, A. K. Ghatak, Tracing rays through graded-index media: a new method, Applied Optics 21 (1982):
// the Runge-Kutta-Nystroem method of fourth order on d2x/dtau2 = n grad n, dtau = ds/n; three evaluations.

RayStep stepSharma(Ray ray, real ds) {
    Optics start = sampleOptics(ray.x);
    real dtau = ds / start.n;
    real3 a = start.gradN * (start.n * dtau);
    Ray halfway = ray;
    halfway.x = ray.x + (ray.w + a * 0.25) * (0.5 * dtau);
    halfway.w = ray.w + a * 0.5;
    Optics middle = sampleOptics(halfway.x);
    real3 b = middle.gradN * (middle.n * dtau);
    Optics end = sampleOptics(ray.x + (ray.w + b * 0.5) * dtau);
    real3 c = end.gradN * (end.n * dtau);
    RayStep taken;
    taken.ray.x = ray.x + (ray.w + (a + 2.0 * b) / 6.0) * dtau;
    taken.ray.w = ray.w + (a + 4.0 * b + c) / 6.0;
    taken.perW = 1.0 / length(taken.ray.w);
    taken.opticalLength = (start.n * start.n + 4.0 * middle.n * middle.n + end.n * end.n) * (dtau / 6.0);
    taken.looked = halfway;
    taken.n = middle.n;
    taken.gradN = middle.gradN;
    return taken;
}

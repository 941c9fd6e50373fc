// Rays through a refractive index field n(x): position x and wave vector w, |w| = n on a true ray.
// Hamiltonian forms with |w| (not n) in the velocity, so that drift and kick separate and drift-kick-drift
// (leapfrog) is symplectic and of second order with one field fetch a step (docs/physics.md, section 1).

struct Ray {
    real3 x;  // position [scene units]
    real3 w;  // wave vector, length n
};

// Viewing rays, constant step of arc length: dx/ds = w/|w|, dw/ds = grad n. Hamiltonian |w| - n.
// `perW`: 1 / |w|.
Ray driftAlong(Ray ray, real perW, real ds) {
    Ray moved = ray;
    moved.x = ray.x + ray.w * (ds * perW);
    return moved;
}

Ray driftByLength(Ray ray, real ds) {
    return driftAlong(ray, 1.0 / length(ray.w), ds);
}

Ray kickByLength(Ray ray, real3 gradN, real ds) {
    Ray turned = ray;
    turned.w = ray.w + gradN * ds;
    return turned;
}

// Wavefronts, constant step of optical path t: dx/dt = w/|w|^2, dw/dt = grad n / n. Hamiltonian ln|w| - ln n.
Ray driftByOpticalPath(Ray ray, real dt) {
    Ray moved = ray;
    moved.x = ray.x + ray.w * (dt / dot(ray.w, ray.w));
    return moved;
}

Ray kickByOpticalPath(Ray ray, real n, real3 gradN, real dt) {
    Ray turned = ray;
    turned.w = ray.w + gradN * (dt / n);
    return turned;
}

// One step of an integrator (physics/step_*.glsl), which evaluates the field where it needs it: whoever includes one says
// what `Optics sampleOptics(real3 x)` is.
struct RayStep {
    Ray ray;             // at its end
    real perW;           // 1 / |w| there
    real opticalLength;  // integral of n over it [scene units]
    Ray looked;          // at the evaluation nearest to its middle
    real n;              // found there
    real3 gradN;         // [1 / scene unit]
};

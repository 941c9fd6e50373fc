// Henyey-Greenstein phase function per steradian: integral over the sphere 1, mean cosine g.
// cosTheta is between the light's direction of travel and the direction of travel towards the eye.

const real kPi = 3.14159265358979323846;

real henyeyGreenstein(real cosTheta, real g) {
    real base = 1.0 + g * g - 2.0 * g * cosTheta;
    base = max(base, 1.0e-12);  // zero only at |g| = 1, where the function is a delta
    return (1.0 - g * g) / (4.0 * kPi * base * sqrt(base));
}

// Phase function for light of several arrivals known by its first two moments: Henyey-Greenstein about the flux vector F
// with g |F|/E in place of g (docs/physics.md, section 5). lightDirection is F/E; a ray from the eye travels along
// viewDirection, so that the light goes the other way.
real phaseOfFlux(real3 viewDirection, real3 lightDirection, real g) {
    real directed = length(lightDirection);
    if (directed < 1.0e-6) {
        return henyeyGreenstein(0.0, 0.0);
    }
    return henyeyGreenstein(-dot(viewDirection, lightDirection) / directed, g * min(directed, 1.0));
}

// The same with g by band.
real3 phaseOfFlux(real3 viewDirection, real3 lightDirection, real3 g) {
    return real3(phaseOfFlux(viewDirection, lightDirection, g.x), phaseOfFlux(viewDirection, lightDirection, g.y),
                 phaseOfFlux(viewDirection, lightDirection, g.z));
}

// Largest error of phaseOfFlux, which is in the forward direction, over the phase function's largest value, per 1 - |F|/E and
// to first order in it. A spread of directions takes l(l + 1)/2 times 1 - |F|/E from the l-th term of the series
// p = sum (2l + 1) g^l P_l / 4 pi, g |F|/E in place of g takes l times; the sum of the differences is closed.
real phaseErrorPerSpread(real g) {
    real a = abs(g);
    real rest = max(1.0 - a, 1.0e-6);
    return a * a * (5.0 + a) / (rest * rest * (1.0 + a));
}

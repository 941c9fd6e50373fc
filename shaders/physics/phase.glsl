// Henyey-Greenstein phase function per steradian: integral over the sphere 1, mean cosine g.
// cosTheta is between the light's direction of travel and the direction of travel towards the eye.

const real kPi = 3.14159265358979323846;

real henyeyGreenstein(real cosTheta, real g) {
    real base = 1.0 + g * g - 2.0 * g * cosTheta;
    base = max(base, 1.0e-12);  // zero only at |g| = 1, where the function is a delta
    return (1.0 - g * g) / (4.0 * kPi * base * sqrt(base));
}

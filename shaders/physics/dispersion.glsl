// Dispersion by Cauchy's equation, n(wavelength) = A + B / wavelength^2, with the index given at the helium d line:
// n(wavelength) = n_d + B (1 / wavelength^2 - 1 / wavelength_d^2). Wavelengths in micrometres, B in square micrometres.

const real kReferenceMicrons = 0.5876;

// What B is multiplied by [1 / micrometre^2]; 0 at the reference.
real dispersionTerm(real wavelengthMicrons) {
    return 1.0 / (wavelengthMicrons * wavelengthMicrons) - 1.0 / (kReferenceMicrons * kReferenceMicrons);
}

real dispersedIndex(real n, real cauchyB, real term) {
    return n + cauchyB * term;
}

// The gradient of that: linear as well.
real3 dispersedGradient(real3 gradN, real3 gradCauchyB, real term) {
    return gradN + gradCauchyB * term;
}

// Uniform cubic B-splines (P. Thévenaz, T. Blu, M. Unser, Interpolation Revisited, IEEE Transactions on Medical Imaging 19,
// 2000): weights of the four coefficients about a place t, 0 to 1, between the second and the third.

real4 splineWeights(real t) {
    real u = 1.0 - t;
    return real4(u * u * u / 6.0, (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0, (4.0 - 3.0 * u * u * (2.0 - u)) / 6.0,
                 t * t * t / 6.0);
}

// Their derivatives by t.
real4 splineSlopes(real t) {
    real u = 1.0 - t;
    return real4(-0.5 * u * u, t * (1.5 * t - 2.0), u * (2.0 - 1.5 * u), 0.5 * t * t);
}

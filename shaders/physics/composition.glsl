// An object over what lies there already (docs/physics.md, section 2): n <- (1 - c) n + c n_o with its coverage c, and the
// gradient of that. Value in the last component, its gradient in the others; `own` is c n_o, and so holds nothing where the
// object does not reach.

real4 composedOver(real4 below, real4 coverage, real4 own) {
    real kept = 1.0 - coverage.w;
    real3 gradient = real3(below) * kept - real3(coverage) * below.w + real3(own);
    return real4(gradient.x, gradient.y, gradient.z, below.w * kept + own.w);
}

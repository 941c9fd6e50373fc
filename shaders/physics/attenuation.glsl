// Beer-Lambert over a step of constant extinction, exact for any optical depth.

// Mean of exp(-tau u) over u in [0, 1]: (1 - exp(-tau))/tau, by its series where the difference would cancel.
real meanTransmittance(real tau) {
    if (tau < 1.0e-2) {
        return 1.0 - tau * (0.5 - tau * (1.0 / 6.0 - tau / 24.0));
    }
    return (1.0 - exp(-tau)) / tau;
}

real3 meanTransmittance3(real3 tau) {
    return real3(meanTransmittance(tau.x), meanTransmittance(tau.y), meanTransmittance(tau.z));
}

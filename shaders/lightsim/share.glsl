// What is left of the power launched along a particle, as a share of its frame's strength. Compiles as C++ too.

float throughputOf(Particle particle) {
    return 0.5 * (particle.throughputS + particle.throughputP);
}

// By band.
vec3 remainingShare(Particle particle) {
    return particle.launchShare * particle.transmittance * throughputOf(particle);
}

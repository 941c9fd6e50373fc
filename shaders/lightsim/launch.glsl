// New patches: corners launched at the source and traced to the present.
#include "lightsim/launch_power.glsl"

// A particle traced from its launch through stepCount steps. The field evaluations are added to `evaluations`.
Particle tracedParticle(LaunchFrame frame, vec2 launch, uint stepCount, inout uint evaluations) {
    Particle particle = particleAtLaunch(frame, launch);
    for (uint i = 0u; i < stepCount; ++i) {
        particle = advance(particle, float(i) * settings.opticalStep);
        evaluations += particle.status == PARTICLE_INSIDE ? 1u : 0u;
    }
    return particle;
}

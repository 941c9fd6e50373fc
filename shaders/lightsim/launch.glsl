// New patches: corners launched at the source and traced to the present.

// Power launched into a rectangle of launch coordinates if the profile is 1 all over it: corners carry their own share. A
// beam: irradiance times area, exact. A point: intensity times solid angle, by 3 x 3 Gauss points of D dA / r^3; its error
// falls with the sixth power of the rectangle's size and is below 1e-6 for the cells of the launch grids.
vec3 launchPower(LaunchFrame frame, vec2 launchMin, vec2 launchMax) {
    vec2 extent = launchMax - launchMin;
    if (frame.isPoint == 0u) {
        return frame.strength * (length(cross(frame.a, frame.b)) * extent.x * extent.y);
    }
    float axisLength = length(frame.axis);
    float areaOverDistance2 = length(frame.a) / axisLength * (length(frame.b) / axisLength) * extent.x * extent.y;
    float solidAngle = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            vec2 place = 0.5 + 0.7745966692 * 0.5 * vec2(float(i - 1), float(j - 1));
            float weight = (i == 1 ? 8.0 : 5.0) * (j == 1 ? 8.0 : 5.0) / 324.0;
            vec2 launch = launchMin + extent * place;
            float ratio = axisLength / length(frame.axis + frame.a * launch.x + frame.b * launch.y);
            solidAngle += weight * ratio * ratio * ratio;
        }
    }
    return frame.strength * (areaOverDistance2 * solidAngle);
}

// A particle traced from its launch through stepCount steps. The field evaluations are added to `evaluations`.
Particle tracedParticle(LaunchFrame frame, vec2 launch, uint stepCount, inout uint evaluations) {
    Particle particle = particleAtLaunch(frame, launch);
    for (uint i = 0u; i < stepCount; ++i) {
        particle = advance(particle, float(i) * settings.opticalStep);
        evaluations += particle.status == PARTICLE_INSIDE ? 1u : 0u;
    }
    return particle;
}

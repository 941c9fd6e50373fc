// The power that a frame launches where its profile is 1: corners carry their own share of it.

// Power per unit of launch coordinates' area, over the frame's strength. A beam: area; a point light: solid angle,
// D dA / r^3 with D the distance of the launch plane.
float launchDensity(LaunchFrame frame, vec2 launch) {
    if (frame.isPoint == 0u) {
        return length(cross(frame.a, frame.b));
    }
    float axisLength = length(frame.axis);
    float ratio = axisLength / length(frame.axis + frame.a * launch.x + frame.b * launch.y);
    return length(frame.a) / axisLength * (length(frame.b) / axisLength) * ratio * ratio * ratio;
}

// Power launched into a rectangle of launch coordinates, over the frame's strength, by 3 x 3 Gauss points: exact for a beam;
// for a point light its error falls with the sixth power of the rectangle's size and is below 1e-6 for the cells of the
// launch grids.
float launchShareOfStrength(LaunchFrame frame, vec2 launchMin, vec2 launchMax) {
    vec2 extent = launchMax - launchMin;
    float density = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            vec2 place = 0.5 + 0.7745966692 * 0.5 * vec2(float(i - 1), float(j - 1));
            float weight = (i == 1 ? 8.0 : 5.0) * (j == 1 ? 8.0 : 5.0) / 324.0;
            density += weight * launchDensity(frame, launchMin + extent * place);
        }
    }
    return density * extent.x * extent.y;
}

// Power launched into a rectangle of launch coordinates, by band.
vec3 launchPower(LaunchFrame frame, vec2 launchMin, vec2 launchMax) {
    return frame.strength * launchShareOfStrength(frame, launchMin, launchMax);
}

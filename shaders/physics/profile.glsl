// Angular profiles of lights: the share, 0 to 1, of the greatest intensity that is launched into a direction.
// direction, axis: unit vectors.

// 1 - cos of the angle between two unit vectors, without cancellation where it is small.
real versineBetween(real3 a, real3 b) {
    real3 chord = a - b;
    return 0.5 * dot(chord, chord);
}

real versineOfAngle(real angle) {
    real s = sin(0.5 * angle);
    return 2.0 * s * s;
}

// A cone that fades between two angles, given by their versines, along a cubic with level ends.
real coneShare(real3 direction, real3 axis, real innerVersine, real outerVersine) {
    real fade = max(outerVersine - innerVersine, 1.0e-20);
    real inside = clamp((outerVersine - versineBetween(direction, axis)) / fade, 0.0, 1.0);
    return inside * inside * (3.0 - 2.0 * inside);
}

// Mean of coneShare over the sphere. The cubic is odd about its middle, so the cone holds as much as a sharp one halfway
// between the two versines, and a cap of versine v is v/2 of the sphere.
real coneMeanShare(real innerVersine, real outerVersine) {
    return 0.25 * (innerVersine + outerVersine);
}

// Lambert: radiance is the same in all directions of the half-space about the normal.
real cosineShare(real3 direction, real3 normal) {
    return max(dot(direction, normal), 0.0);
}

// Mean of cosineShare over the sphere.
real cosineMeanShare() {
    return 0.25;
}

// Radiance from infinitely far away, by direction. +Y is up.

const real kHalfTurn = 3.14159265358979323846;

// Texture coordinate of a direction in a latitude-longitude map as OpenEXR lays it out: u = 1/2 is +Z, u = 1/4 is +X,
// v = 0 is +Y. By atan in both, which is precise everywhere; acos is not near the poles.
real2 latLongFromDirection(real3 direction) {
    real longitude = atan(direction.x, direction.z);
    real latitude = atan(direction.y, sqrt(direction.x * direction.x + direction.z * direction.z));
    return real2(0.5 - longitude / (2.0 * kHalfTurn), 0.5 - latitude / kHalfTurn);
}

real3 directionFromLatLong(real2 uv) {
    real longitude = (0.5 - uv.x) * 2.0 * kHalfTurn;
    real latitude = (0.5 - uv.y) * kHalfTurn;
    return real3(sin(longitude) * cos(latitude), sin(latitude), cos(longitude) * cos(latitude));
}

// The direction in an environment's own frame, when the environment is turned about +Y by an angle [radians].
real3 turnedAboutY(real3 direction, real angle) {
    real c = cos(angle);
    real s = sin(angle);
    return real3(c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z);
}

// From the horizon's colour, also below it, to the zenith's, linear in the sine of the elevation.
real3 gradientRadiance(real3 direction, real3 horizon, real3 zenith) {
    return horizon + (zenith - horizon) * clamp(direction.y, 0.0, 1.0);
}

// Tubes of rays: but for losses the power in one is constant, so irradiance is power over cross-section
// (docs/physics.md, section 3; Eq. 4.16 of the 2007 thesis).

// Cross-section of a tube about four rays, in order around it, by a plane across their common direction. Negative where the
// tube is turned inside out: the corners run around the direction the other way.
real crossSection(real3 x0, real3 x1, real3 x2, real3 x3, real3 unitDirection) {
    return 0.5 * dot(cross(x2 - x0, x3 - x1), unitDirection);
}

// The same with both senses counted as positive, by the mean over the four corners: what the light of the tube covers, also
// where a fold runs through it and parts of opposite sense cancel in the cross-section.
real coveredSection(real3 x0, real3 x1, real3 x2, real3 x3, real3 unitDirection) {
    real corner0 = abs(dot(cross(x1 - x0, x3 - x0), unitDirection));
    real corner1 = abs(dot(cross(x2 - x1, x0 - x1), unitDirection));
    real corner2 = abs(dot(cross(x3 - x2, x1 - x2), unitDirection));
    real corner3 = abs(dot(cross(x0 - x3, x2 - x3), unitDirection));
    return 0.25 * (corner0 + corner1 + corner2 + corner3);
}

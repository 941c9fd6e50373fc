// Where opaque matter cuts a cell: rays are interpolated with beyond it, but light ends there.

// The part of the steps in front of opaque matter at a place (u, v) of a cell; below 0 or above 1 where that lies before or behind.
float litPartAt(uint cell, vec2 at) {
#ifdef EFFECT_OPAQUE
    vec4 parts = cellRow(cell, kLitPartsRow);
    return mix(mix(parts.x, parts.y, at.x), mix(parts.z, parts.w, at.x), at.y);
#else
    return 1.0;
#endif
}

// The same at a corner.
float litPartAtCorner(uint cell, int corner) {
#ifdef EFFECT_OPAQUE
    return clamp(cellRow(cell, kLitPartsRow)[corner], 0.0, 1.0);
#else
    return 1.0;
#endif
}

// Whether light comes to a place of a cell.
bool isLit(uint cell, vec3 at) {
    return isPastMirror(cell, at) && at.z <= litPartAt(cell, at.xy);
}

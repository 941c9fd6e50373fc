// Where the mirror that light is followed from cuts a cell: before it is only the image that rays are interpolated with.

// Whether light has passed the mirror at a place of a cell.
bool isPastMirror(uint cell, vec3 at) {
#ifdef FOLLOW_REFLECTIONS
    vec4 steps = mix(cellRow(cell, kFirstMirrorRow), cellRow(cell, kFirstMirrorRow + 1), at.z);
    return mix(mix(steps.x, steps.y, at.x), mix(steps.z, steps.w, at.x), at.y) >= 0.0;
#else
    return true;
#endif
}

// The part of the steps at a place (u, v) of a cell that lies before the mirror; below 0 or above 1 where it is met before or after.
float partBeforeMirrorAt(uint cell, vec2 at) {
#ifdef FOLLOW_REFLECTIONS
    vec4 first = cellRow(cell, kFirstMirrorRow);
    vec4 last = cellRow(cell, kFirstMirrorRow + 1);
    float before = mix(mix(first.x, first.y, at.x), mix(first.z, first.w, at.x), at.y);
    float after = mix(mix(last.x, last.y, at.x), mix(last.z, last.w, at.x), at.y);
    return before / min(before - after, -1.0e-6);
#else
    return 0.0;
#endif
}

// The part of the steps along a corner of a cell that lies before the mirror.
float partBeforeMirror(uint cell, int corner) {
    return clamp(partBeforeMirrorAt(cell, vec2(corner & 1, corner >> 1)), 0.0, 1.0);
}

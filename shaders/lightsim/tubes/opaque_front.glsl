// The surface at which opaque matter ends light, over launch coordinates: neighbours meet it at different times, and while some
// have and others have not, that is no shadow between them. Whoever includes this has the mesh's vertices.

// Where rays end, in steps of the window; kNoEnd: not yet, or it is not known.
const float kNoEnd = 1.0e9;

#ifdef EFFECT_OPAQUE
float endOf(uint vertex) {
    float at = vertices[vertex].ray.blockedAt;
    return at > 0.0 ? at - float(tube.firstStep) : kNoEnd;
}
#else
float endOf(uint vertex) {
    return kNoEnd;
}
#endif

// Whether a ray ends where its neighbours say, all of which do.
bool isOneSurface(float end, float expected) {
    float step = settings.opticalStep;
    return end < 0.5 * kNoEnd && expected < 0.5 * kNoEnd && abs(end - expected) * step < tube.maxDeviation;
}

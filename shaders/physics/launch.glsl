// The straight line on which light leaves a launch frame (lightsim/emit.h), and whether it meets the domain.

struct LaunchLine {
    real3 target;         // where it crosses the launch plane [scene units, from the domain's middle]
    real3 direction;      // of travel, unit
    real sourceDistance;  // from the source to the target [scene units]; a beam comes from far away
};

// `offset`: of the target from the plane's centre, perpendicular to the axis. `origin`: a point light's position, or a beam's direction.
LaunchLine launchLine(bool isPoint, real3 origin, real3 centre, real3 axis, real3 offset) {
    LaunchLine line;
    line.target = centre + offset;
    line.direction = origin;
    line.sourceDistance = 1.0e30;
    if (isPoint) {
        real3 toTarget = axis + offset;
        line.sourceDistance = length(toTarget);
        line.direction = toTarget / line.sourceDistance;
    }
    return line;
}

// `span`: of the line in the domain, from its target.
bool meetsDomain(LaunchLine line, BoxSpan span) {
    const real kAhead = 0.9999;  // a source on a face: what leaves it outwards does so at once, but for rounding
    return span.enter < span.leave && span.leave > -kAhead * line.sourceDistance;
}

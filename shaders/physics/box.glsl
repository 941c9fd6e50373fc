// Where a straight line meets an axis-aligned box.

struct BoxSpan {
    real enter;  // distance along the line to the first face [units of the direction's length]
    real leave;  // distance to the last face; leave < enter: the line misses the box
};

// Slab test. Zero components of the direction give no bounds: the line is inside that slab or misses the box.
BoxSpan boxSpan(real3 origin, real3 direction, real3 boxMin, real3 boxMax) {
    BoxSpan span;
    span.enter = -1.0e30;
    span.leave = 1.0e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < boxMin[axis] || origin[axis] > boxMax[axis]) {
                span.leave = -1.0e30;
            }
        } else {
            real a = (boxMin[axis] - origin[axis]) / direction[axis];
            real b = (boxMax[axis] - origin[axis]) / direction[axis];
            span.enter = max(span.enter, min(a, b));
            span.leave = min(span.leave, max(a, b));
        }
    }
    return span;
}

// Distance along the direction at which a point inside the box leaves it.
real distanceToExit(real3 x, real3 direction, real3 boxMin, real3 boxMax) {
    real leave = 1.0e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] > 0.0) {
            leave = min(leave, (boxMax[axis] - x[axis]) / direction[axis]);
        } else if (direction[axis] < 0.0) {
            leave = min(leave, (boxMin[axis] - x[axis]) / direction[axis]);
        }
    }
    return max(leave, 0.0);
}

struct SlicePoint {
    real3 x;
    bool isMet;  // false: the look goes along the slice or away from it, or meets its plane beside the box
};

// Where a look from the origin along the direction meets the slice of the box on which coordinate `axis` is `position`.
SlicePoint slicePoint(real3 origin, real3 direction, int axis, real position, real3 boxMin, real3 boxMax) {
    real along = (position - origin[axis]) / direction[axis];
    SlicePoint point;
    point.x = origin + direction * along;
    point.isMet = along > 0.0;
    for (int other = 0; other < 3; ++other) {
        point.isMet = point.isMet && point.x[other] >= boxMin[other] && point.x[other] <= boxMax[other];
    }
    return point;
}

// Steps near the faces of the domain: the last one is cut there.

bool outside(vec3 x) {
    return any(lessThan(x, domain.min)) || any(greaterThan(x, domain.max));
}

float distanceToFace(RayState ray) {
    return distanceToExit(ray.x, unitDirection(ray), domain.min, domain.max);
}

// Length of the next step: the last one ends at the face, so that it turns the ray by no more than it goes. It may be as
// short as kShortestStep of the usual one; below that the ray is taken to stand on the face.
const float kShortestStep = 1e-3;

float nextStepLength(RayState ray) {
    float usual = usualStepAt(ray.x);
    if (!outside(driftByLength(Ray(ray.x, ray.w), usual).x)) {
        return usual;
    }
    return clamp(distanceToFace(ray), kShortestStep * usual, usual);
}

// Moves the ray straight on, to the face of the domain at most; the length it went.
float drift(inout RayState ray, float ds) {
    vec3 moved = driftByLength(Ray(ray.x, ray.w), ds).x;
    float went = ds;
    if (outside(moved)) {
        went = min(distanceToFace(ray), ds);
        moved = clamp(driftByLength(Ray(ray.x, ray.w), went).x, domain.min, domain.max);
        ray.status = kExited;
    }
    ray.x = moved;
    return went;
}

// The second drift of the last step goes on to the face, which the turn has moved a little nearer or farther.
float lastDrift(inout RayState ray, float ds) {
    float toFace = distanceToFace(ray);
    return drift(ray, toFace < 2.0 * ds ? 1.001 * toFace + kShortestStep * view.stepLength : ds);
}

// Along a ray that is inside or has just left: below 0 beyond the face.
float signedDistanceToFace(Ray ray) {
    return boxSpan(ray.x, ray.w / length(ray.w), domain.min, domain.max).leave;
}

// Lengths tried of a step that must end at the face: each brings what is missing to its square.
const int kFaceTrials = 3;

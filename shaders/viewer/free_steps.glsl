// Steps on which nothing acts but the index: kick and drift, and nothing else. Half drifts of neighbouring steps are one, places
// are texture coordinates, and a step that turns out to leave the domain is taken back afterwards.
//
// A vector of rays on the software renderer waits for every operation between a fetch and the place of the next, and pays for
// every number that a turn of the loop changes: here they are as few as can be.

bool isWithin(vec3 coordinate) {
    return all(lessThanEqual(abs(coordinate - 0.5), vec3(0.5)));
}

// By which a ray drifts in half a step, in texture coordinates. `stepScale`: of a step's length, by axis.
vec3 halfDrift(vec3 w, vec3 stepScale) {
    return driftAlong(Ray(vec3(0.0), w * stepScale), 1.0 / length(w), 0.5).x;
}

// What free steps bring.
struct FreeSteps {
    vec3 next;     // middle of the step after them
    vec3 w;        // before it
    float n;       // at the last evaluation
    float sumOfN;  // over all of them
    uint count;
    bool bent;     // by the last one
};

// Takes the last step back: half drift, kick, half drift.
void takeBack(inout FreeSteps steps, vec3 stepScale) {
    steps.next -= 2.0 * halfDrift(steps.w, stepScale);
    Optics there = domainOptics(steps.next);
    steps.w = kickByLength(Ray(steps.next, steps.w), there.gradN, -view.stepLength).w;
    steps.n = length(steps.w);  // as on a true ray
    steps.sumOfN -= there.n;
    steps.count -= 1u;
}

void move(inout RayState ray, FreeSteps steps, vec3 stepScale) {
    float ds = view.stepLength;
    ray.x = placeOf(steps.next - halfDrift(steps.w, stepScale));
    ray.w = steps.w;
    ray.n = steps.n;
    ray.pathLength += (float(steps.count) - 1.0) * ds;
    noteBend(ray, steps.bent, ds);
    ray.pathLength += ds;
    ray.opticalLength += steps.sumOfN * ds;
}

// Steps until the next one may leave the domain: true. Or the ray may fly, or has come to the slice's end.
bool stepAlong(inout RayState ray, inout uint left) {
    vec3 stepScale = view.stepLength * domain.scale;
    uint most = stepsLeft(ray, left);
    uint beforeLook = stepsBeforeLook(ray, view.stepLength);
    vec3 middle = coordinateOf(ray.x) + halfDrift(ray.w, stepScale);
    FreeSteps steps = FreeSteps(middle, ray.w, ray.n, 0.0, 0u, false);
    bool goesOn = isPlain(ray, most) && isWithin(middle);
    while (goesOn) {
        Optics there = domainOptics(steps.next);
        steps.w = kickByLength(Ray(steps.next, steps.w), there.gradN, view.stepLength).w;
        steps.next = driftAlong(Ray(steps.next, steps.w * stepScale), 1.0 / length(steps.w), 1.0).x;
        steps.n = there.n;
        steps.sumOfN += there.n;
        steps.count += 1u;
        steps.bent = isBend(there.gradN);
        goesOn = isWithin(steps.next) && steps.count < most && (steps.bent || steps.count < beforeLook);
    }
    bool leaves = !isWithin(steps.next);
    if (steps.count > 0u) {
        ray.evaluations += steps.count;
        if (!isWithin(steps.next - halfDrift(steps.w, stepScale))) {
            takeBack(steps, stepScale);
            ray.evaluations += 1u;
            leaves = true;
        }
        move(ray, steps, stepScale);
        left -= steps.count;
    }
    endRay(ray);
    return leaves && isPlain(ray, left);
}

// Steps on which nothing acts but the index: kick and drift, and nothing else. Half drifts of neighbouring steps are one, places
// are texture coordinates, and a step that turns out to leave the domain is taken back afterwards.
//
// A vector of rays on the software renderer waits for every operation between a fetch and the place of the next, and pays for
// every number that a turn of the loop changes: here they are as few as can be, and one ray's are worked out while another's
// fetch is under way.

// Where rays fly, which one does while others step, they would wait for each other more than they gain; and what meets dispersion
// is noted by invocation.
#if !defined(STRAIGHT_FLIGHTS) && !defined(EFFECT_DISPERSION)
#define RAYS_AT_ONCE 2
#else
#define RAYS_AT_ONCE 1
#endif
#ifndef BLOCKS_IN_TURN
#define BLOCKS_IN_TURN 1
#endif
#define ENTRIES (RAYS_AT_ONCE * BLOCKS_IN_TURN)
#include "viewer/steps.glsl"

// In the domain's box, 0 to 1: such numbers come first by their bits, before greater and negative ones and what is no number.
bool isWithin(vec3 coordinate) {
    const uint kOne = 0x3f800000u;
    uvec3 bits = floatBitsToUint(coordinate);
    return max(max(bits.x, bits.y), bits.z) <= kOne;
}

// By which a ray drifts in half a step, in texture coordinates. `stepScale`: of a step's length, by axis.
vec3 halfDrift(vec3 w, vec3 stepScale) {
    return driftAlong(Ray(vec3(0.0), w * stepScale), 1.0 / length(w), 0.5).x;
}

// A ray's free steps from where it is.
struct FreeSteps {
    vec3 next;     // middle of the step after them
    vec3 perStep;  // wave vector before it, by the length of a step: kicks are gradients
    float n;       // at the last evaluation
    float sumOfN;  // over all of them
    uint count;
    bool bent;     // by the last one
    bool goOn;
    uint most, beforeLook;
};

FreeSteps beginSteps(RayState ray, uint left, vec3 stepScale) {
    FreeSteps steps;
    steps.next = coordinateOf(ray.x) + halfDrift(ray.w, stepScale);
    steps.perStep = ray.w / view.stepLength;
    steps.n = ray.n;
    steps.sumOfN = 0.0;
    steps.count = 0u;
    steps.bent = false;
    steps.most = stepsLeft(ray, left);
    steps.beforeLook = stepsBeforeLook(ray, view.stepLength);
    steps.goOn = isPlain(ray, steps.most) && isWithin(steps.next);
    return steps;
}

void takeStep(inout FreeSteps steps, vec3 stepScale) {
    Optics there = domainOptics(steps.next);
    if (RAYS_AT_ONCE == 1 || steps.goOn) {  // one that has come to its end lets the other go on
        Ray turned = kickByLength(Ray(steps.next, steps.perStep), there.gradN, 1.0);
        steps.perStep = turned.w;
        steps.next = driftAlong(Ray(turned.x, turned.w * stepScale), 1.0 / length(turned.w), 1.0).x;
        steps.n = there.n;
        steps.sumOfN += there.n;
        steps.count += 1u;
        steps.bent = isBend(there.gradN);
        steps.goOn = isWithin(steps.next) && steps.count < steps.most && (steps.bent || steps.count < steps.beforeLook);
    }
}

// Takes the last step back: half drift, kick, half drift.
void takeBack(inout FreeSteps steps, vec3 stepScale) {
    steps.next -= 2.0 * halfDrift(steps.perStep, stepScale);
    Optics there = domainOptics(steps.next);
    steps.perStep = kickByLength(Ray(steps.next, steps.perStep), there.gradN, -1.0).w;
    steps.n = length(steps.perStep) * view.stepLength;  // as on a true ray
    steps.sumOfN -= there.n;
    steps.count -= 1u;
}

void move(inout RayState ray, FreeSteps steps, vec3 stepScale) {
    float ds = view.stepLength;
    ray.x = placeOf(steps.next - halfDrift(steps.perStep, stepScale));
    ray.w = steps.perStep * ds;
    ray.n = steps.n;
    ray.pathLength += (float(steps.count) - 1.0) * ds;
    noteBend(ray, steps.bent, ds);
    ray.pathLength += ds;
    ray.opticalLength += steps.sumOfN * ds;
}

// Whether the ray's next step may leave the domain.
bool endSteps(inout RayState ray, inout uint left, FreeSteps steps, vec3 stepScale) {
    bool leaves = !isWithin(steps.next);
    if (steps.count > 0u) {
        ray.evaluations += steps.count;
        if (!isWithin(steps.next - halfDrift(steps.perStep, stepScale))) {
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

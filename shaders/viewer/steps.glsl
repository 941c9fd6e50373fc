// Steps of arc length of viewing rays by an integrator (viewer/integrator.glsl), and what lies along them.
#include "viewer/ray_states.glsl"
#include "viewer/ray_lists.glsl"
#include "fields/fields.glsl"
#include "viewer/integrator.glsl"
#include "physics/box.glsl"
#include "viewer/matter.glsl"

// A step as two straight pieces, which meet near where the field is evaluated.
struct Step {
    vec3 start, middle, end;
    vec3 wStart, wEnd;   // wave vector
    vec3 w;              // at the evaluation
    float first, second; // lengths of the pieces [scene units]
    float nBefore;       // index at the evaluation before
    float nMean;         // index over the step
    Optics optics;       // at the evaluation
    bool inBand;         // of a boundary
};

#include "viewer/boundary_crossing.glsl"

void endFaintRay(inout RayState ray) {
#if defined(MATTER) || defined(EFFECT_REFLECTION)
    vec3 left = rayThroughput(ray);
    if (ray.status == kMarching && max(left.r, max(left.g, left.b)) < view.minThroughput) {
        ray.status = kAttenuated;
    }
#endif
}

uint evaluationsLeft(RayState ray) {
    return view.maxEvaluations - min(ray.evaluations + ray.lookUps, view.maxEvaluations);
}

void endRay(inout RayState ray) {
    endFaintRay(ray);
    if (ray.status == kMarching && evaluationsLeft(ray) == 0u) {
        ray.status = kStepLimit;
    }
}

#include "viewer/opaque_hit.glsl"
#include "viewer/flight.glsl"
#include "viewer/face_step.glsl"

// Whether the ray is where it must step, and may.
bool isPlain(RayState ray, uint left) {
    return left > 0u && ray.status == kMarching && !looksAhead(ray);
}

uint stepsLeft(RayState ray, uint left) {
    return min(left, (evaluationsLeft(ray) + kEvaluationsPerStep - 1u) / kEvaluationsPerStep);
}

Step stepOf(RayState ray, RayStep next, float ds) {
    Step taken;
    taken.start = ray.x;
    taken.middle = middleOf(Ray(ray.x, ray.w), next);
    taken.end = next.ray.x;
    taken.wStart = ray.w;
    taken.w = next.looked.w;
    taken.wEnd = next.ray.w;
    taken.first = 0.5 * ds;
    taken.second = taken.first;
    taken.nBefore = ray.n;
    taken.nMean = meanIndex(next, ds);
    taken.optics = Optics(next.n, next.gradN);
    taken.inBand = inBoundary(next.looked.x);
    return taken;
}

// Matter is sampled at least every voxel or so, whatever the step: once a step in its middle, or SAMPLES_PER_HALF
// times on each of its two pieces.
void passStep(inout RayState ray, Step taken) {
    ray.pathLength += taken.first + taken.second;
    ray.opticalLength += taken.nMean * (taken.first + taken.second);
#ifdef MATTER
    vec3 direction = taken.w / length(taken.w);
#if SAMPLES_PER_HALF == 0
    vec3 x = taken.second > 0.0 ? taken.middle : 0.5 * (taken.start + taken.middle);
    passMatter(ray, x, direction, ray.n, taken.first + taken.second);
#else
    for (int i = 0; i < 2 * SAMPLES_PER_HALF; ++i) {
        bool first = i < SAMPLES_PER_HALF;
        float share = (float(first ? i : i - SAMPLES_PER_HALF) + 0.5) / float(SAMPLES_PER_HALF);
        vec3 x = first ? mix(taken.start, taken.middle, share) : mix(taken.middle, taken.end, share);
        passMatter(ray, x, direction, ray.n, (first ? taken.first : taken.second) / float(SAMPLES_PER_HALF));
    }
#endif
#endif
}

// Whether something happens in a step that most steps pass without: the domain ends, a boundary does, or opaque matter is met.
bool isEventful(RayState ray, Step taken) {
    return outside(taken.middle) || outside(taken.end) || boundaryEnds(ray, taken.inBand, taken.optics) || meetsOpaque(taken);
}

// The ray at the end of a step; what lies along it is not passed yet.
void move(inout RayState ray, Step taken) {
    ray.x = taken.end;
    ray.w = taken.wEnd;
    ray.n = taken.optics.n;
    noteBend(ray, isBend(taken.optics.gradN), taken.first + taken.second);
}

// What marching changes.
void storeRay(RayState marched) {
    RayState ray = marched;
#ifdef EFFECT_DISPERSION
    ray.dispersed |= uint(hasMetDispersion);
#endif
    RayRows rows = rowsOf(ray);
    storeRows(rayIndex, rows, 0, kCourseRow);
#if defined(STRAIGHT_FLIGHTS) || defined(EFFECT_DISPERSION) || defined(MATTER)
    storeRows(rayIndex, rows, kCourseRow, kMatterRow);
#endif
#ifdef MATTER
    storeRows(rayIndex, rows, kMatterRow, kSeenRow);
#endif
#if defined(MATTER) || defined(EFFECT_REFLECTION)
    storeRows(rayIndex, rows, kSeenRow, kCrossingRow);
#endif
#ifdef EFFECT_REFLECTION
    storeRows(rayIndex, rows, kCrossingRow, kRowsPerRay);
#endif
    storeBoundary();
}

// What is to be listed for the next slice.
uint passOn(RayState ray, bool eventful) {
    storeRay(ray);
    return ray.status != kMarching ? kNoEntry : eventful ? rayIndex : rayIndex | kIsPlain;
}

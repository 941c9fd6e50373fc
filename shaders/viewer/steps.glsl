// Steps of arc length of viewing rays by an integrator (viewer/integrator.glsl), and what lies along them.
#include "viewer/ray_states.glsl"
#include "viewer/ray_lists.glsl"
#include "fields/fields.glsl"
#include "viewer/integrator.glsl"
#include "physics/box.glsl"
#include "viewer/boundary_crossing.glsl"
#include "viewer/matter.glsl"

layout(local_size_x = kRaysPerGroup) in;

// A step as two straight pieces, which meet near where the field is evaluated.
struct Step {
    vec3 start, middle, end;
    vec3 w;              // wave vector at the evaluation
    vec3 wEnd;           // at the end
    float first, second; // lengths of the pieces [scene units]
    float nBefore;       // index at the evaluation before
    float nMean;         // index over the step
    Optics optics;       // at the evaluation
    bool inBand;         // of a boundary
};

void endRay(inout RayState ray) {
#if defined(MATTER) || defined(EFFECT_REFLECTION)
    vec3 left = rayThroughput(ray);
    if (ray.status == kMarching && max(left.r, max(left.g, left.b)) < minThroughput) {
        ray.status = kAttenuated;
    }
#endif
    if (ray.status == kMarching && ray.evaluations + ray.lookUps >= maxEvaluations) {
        ray.status = kStepLimit;
    }
}

#include "viewer/opaque_hit.glsl"
#include "viewer/flight.glsl"
#include "viewer/face_step.glsl"

Step stepOf(RayState ray, RayStep next, float ds) {
    Step taken;
    taken.start = ray.x;
    taken.middle = middleOf(Ray(ray.x, ray.w), next);
    taken.end = next.ray.x;
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

// Matter is sampled at least every MATTER_VOXELS voxels, whatever the step: once a step in its middle, or SAMPLES_PER_HALF
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
    noteBend(ray, taken.optics.gradN, taken.first + taken.second);
}

// What marching changes: the rest of a state is neither read nor written.
void storeRay(RayState ray) {
    rays[rayIndex].x = ray.x;
    rays[rayIndex].w = ray.w;
    rays[rayIndex].n = ray.n;
    rays[rayIndex].status = ray.status;
    rays[rayIndex].pathLength = ray.pathLength;
    rays[rayIndex].opticalLength = ray.opticalLength;
    rays[rayIndex].evaluations = ray.evaluations;
#ifdef EFFECT_DISPERSION
    rays[rayIndex].dispersed = ray.dispersed | uint(hasMetDispersion);
#endif
#ifdef STRAIGHT_FLIGHTS
    rays[rayIndex].lookUps = ray.lookUps;
    rays[rayIndex].lookAgainAt = ray.lookAgainAt;
#endif
#ifdef MATTER
    rays[rayIndex].depth = ray.depth;
    rays[rayIndex].transmittance = ray.transmittance;
    rays[rayIndex].matterSamples = ray.matterSamples;
#endif
#if defined(MATTER) || defined(EFFECT_REFLECTION)
    rays[rayIndex].radiance = ray.radiance;
#endif
#ifdef EFFECT_REFLECTION
    rays[rayIndex].throughputS = ray.throughputS;
    rays[rayIndex].throughputP = ray.throughputP;
    rays[rayIndex].crossingNormal = ray.crossingNormal;
    rays[rayIndex].crossingGradMax = ray.crossingGradMax;
    rays[rayIndex].crossingStart = ray.crossingStart;
    rays[rayIndex].crossingWTangential = ray.crossingWTangential;
    rays[rayIndex].crossingSide = ray.crossingSide;
#endif
    storeSteepest();
}

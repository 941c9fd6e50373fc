// Viewing rays through the domain, a slice of their steps: straight flights where nothing bends them, else steps of arc
// length by an integrator (viewer/integrator.glsl). Rays that have ended return at once.
//
// A vector of rays pays for every line between two turns of a loop, whether or not one of them takes that branch. So the
// innermost loop holds what every step needs; whatever happens now and then ends it and is dealt with outside. And a loop runs
// until all rays of the vector have left it: rays fly, come away from the faces, and step, each all together.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"
#include "viewer/integrator.glsl"
#include "physics/box.glsl"
#include "viewer/boundary_crossing.glsl"
#include "viewer/matter.glsl"

layout(local_size_x = kRaysPerGroup) in;

// Groups of the next slice: up to the last one that holds a ray under way.
layout(std430, binding = kStorageMarchGroups) buffer MarchGroups { uvec3 nextGroups; };

// A step as two straight pieces, which meet near where the field is evaluated.
struct Step {
    vec3 start, middle, end;
    vec3 w;              // wave vector at the evaluation
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

// Moves the ray by a step of length ds and notes what its evaluations have found.
Step advance(inout RayState ray, RayStep next, float ds) {
    Step taken;
    taken.start = ray.x;
    taken.middle = middleOf(Ray(ray.x, ray.w), next);
    taken.end = next.ray.x;
    taken.w = next.looked.w;
    taken.first = 0.5 * ds;
    taken.second = taken.first;
    taken.nBefore = ray.n;
    taken.nMean = meanIndex(next, ds);
    taken.optics = Optics(next.n, next.gradN);
    taken.inBand = inBoundary(next.looked.x);
    ray.x = next.ray.x;
    ray.w = next.ray.w;
    ray.n = next.n;
    ray.evaluations += kEvaluationsPerStep;
    noteBend(ray, next.gradN, ds);
    return taken;
}

// A step that cannot reach a face.
Step innerStep(inout RayState ray) {
    float ds = usualStepAt(ray.x);
    return advance(ray, stepRay(Ray(ray.x, ray.w), ds), ds);
}

#ifdef INTEGRATOR_LEAPFROG

// Evaluates the field where the ray is, in the middle of its step, and turns it.
void kick(inout RayState ray, inout Step taken, float ds) {
    taken.optics = sampleOptics(ray.x);
    taken.inBand = inBoundary(ray.x);
    taken.w = ray.w;
    ray.evaluations += 1u;
    ray.n = taken.optics.n;
    taken.nMean = ray.n;
#ifdef EFFECT_REFRACTION
    taken.w = kickByLength(Ray(ray.x, ray.w), taken.optics.gradN, 0.5 * ds).w;
    ray.w = kickByLength(Ray(ray.x, ray.w), taken.optics.gradN, ds).w;
#endif
    noteBend(ray, taken.optics.gradN, ds);
}

// A step that may end at the face, which the first half of it may reach.
Step outerStep(inout RayState ray) {
    Step taken;
    float usual = usualStepAt(ray.x);
    float ds = nextStepLength(ray);
    taken.start = ray.x;
    taken.nBefore = ray.n;
    taken.nMean = ray.n;
    taken.w = ray.w;
    taken.optics = Optics(ray.n, vec3(0.0));
    taken.inBand = true;
    taken.first = drift(ray, 0.5 * ds);
    taken.middle = ray.x;
    taken.second = 0.0;
    if (ray.status == kMarching) {
        kick(ray, taken, ds);
        taken.second = ds < usual ? lastDrift(ray, 0.5 * ds) : drift(ray, 0.5 * ds);
    }
    taken.end = ray.x;
    return taken;
}

#else

// A step that may end at the face: there it is taken again until it has the length that ends on it.
Step outerStep(inout RayState ray) {
    Ray start = Ray(ray.x, ray.w);
    float usual = usualStepAt(ray.x);
    float ds = nextStepLength(ray);
    bool last = ds < usual;
    RayStep next = stepRay(start, ds);
    for (int i = 0; i < kFaceTrials && (last || outside(next.ray.x)); ++i) {
        last = true;
        ds = clamp(ds + signedDistanceToFace(next.ray), kShortestStep * usual, usual);
        next = stepRay(start, ds);
    }
    Step taken = advance(ray, next, ds);
    if (signedDistanceToFace(next.ray) < kShortestStep * stepLength) {
        ray.status = kExited;
        ray.x = clamp(ray.x, domainMin, domainMax);
        taken.end = ray.x;
    }
    return taken;
}

#endif

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

// Whether something happens in a step that most steps pass without: a boundary ends, or opaque matter is met.
bool isEventful(RayState ray, Step taken) {
    return boundaryEnds(ray, taken.inBand, taken.optics) || meetsOpaque(taken);
}

// Steps until something happens, the ray comes near a face, or it may fly. The last one is not passed yet if something
// happened in it: true.
bool stepAlong(inout RayState ray, inout Step taken, inout uint left) {
    bool eventful = false;
    while (!eventful && left > 0u && ray.status == kMarching && farFromFaces(ray.x) && !looksAhead(ray)) {
        taken = innerStep(ray);
        eventful = isEventful(ray, taken);
        if (!eventful) {
            followBoundary(ray, taken.nBefore, taken.inBand, taken.middle, taken.w, taken.optics);
            passStep(ray, taken);
            endRay(ray);
        }
        left -= 1u;
    }
    return eventful;
}

void finishStep(inout RayState ray, Step taken) {
    endBoundary(ray, taken.nBefore, taken.inBand, taken.middle, taken.w, taken.optics);
    cutAtOpaque(ray, taken);
    passStep(ray, taken);
    endRay(ray);
}

// Steps while a face is near.
void stepNearFaces(inout RayState ray, inout uint left) {
    while (left > 0u && ray.status == kMarching && !farFromFaces(ray.x) && !looksAhead(ray)) {
        Step taken = outerStep(ray);
        finishStep(ray, taken);
        left -= 1u;
    }
}

// What marching changes: the rest of a state is neither read nor written.
void storeRay(uint index, RayState ray) {
    rays[index].x = ray.x;
    rays[index].w = ray.w;
    rays[index].n = ray.n;
    rays[index].status = ray.status;
    rays[index].pathLength = ray.pathLength;
    rays[index].opticalLength = ray.opticalLength;
    rays[index].evaluations = ray.evaluations;
#ifdef EFFECT_DISPERSION
    rays[index].dispersed = ray.dispersed | uint(hasMetDispersion);
#endif
#ifdef STRAIGHT_FLIGHTS
    rays[index].lookUps = ray.lookUps;
    rays[index].lookAgainAt = ray.lookAgainAt;
#endif
#ifdef MATTER
    rays[index].depth = ray.depth;
    rays[index].transmittance = ray.transmittance;
    rays[index].matterSamples = ray.matterSamples;
#endif
#if defined(MATTER) || defined(EFFECT_REFLECTION)
    rays[index].radiance = ray.radiance;
#endif
#ifdef EFFECT_REFLECTION
    rays[index].throughputS = ray.throughputS;
    rays[index].throughputP = ray.throughputP;
    rays[index].crossingNormal = ray.crossingNormal;
    rays[index].crossingGradMax = ray.crossingGradMax;
    rays[index].crossingStart = ray.crossingStart;
    rays[index].crossingWTangential = ray.crossingWTangential;
    rays[index].crossingSide = ray.crossingSide;
#endif
    storeSteepest(index);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= rayCount || rays[index].status != kMarching) {
        return;
    }
    RayState ray = rays[index];
    loadSteepest(index);
    stopInsideOpaque(ray);
    uint left = stepsPerSlice;
    while (left > 0u && ray.status == kMarching) {
        flyAhead(ray, left);
        stepNearFaces(ray, left);
        Step eventful;
        if (stepAlong(ray, eventful, left)) {
            finishStep(ray, eventful);
        }
    }
    storeRay(index, ray);
    if (ray.status == kMarching) {
        atomicMax(nextGroups.x, gl_WorkGroupID.x + 1u);
    }
}

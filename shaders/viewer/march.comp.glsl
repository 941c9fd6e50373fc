// Viewing rays through the domain, a slice of their steps: a straight flight where nothing bends them, else drift, kick,
// drift by arc length (physics/ray.glsl). The last step is cut at the face. Rays that have ended return at once.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"
#include "physics/ray.glsl"
#include "physics/box.glsl"
#include "viewer/boundary_crossing.glsl"
#include "viewer/matter.glsl"

layout(local_size_x = kRaysPerGroup) in;

// A step: two straight pieces that meet where the field is evaluated.
struct Step {
    vec3 start, middle, end;
    vec3 direction;      // in the middle, unit
    float first, second; // lengths of the pieces [scene units]
};

#include "viewer/opaque_hit.glsl"
#include "viewer/flight.glsl"

bool outside(vec3 x) {
    return any(lessThan(x, domainMin)) || any(greaterThan(x, domainMax));
}

float distanceToFace(RayState ray) {
    return distanceToExit(ray.x, unitDirection(ray), domainMin, domainMax);
}

// Length of the next step: the last one ends at the face, so that it turns the ray by no more than it goes. It may be as
// short as kShortestStep of the usual one; below that the ray is taken to stand on the face.
const float kShortestStep = 1e-3;

float nextStepLength(RayState ray) {
    if (!outside(driftByLength(Ray(ray.x, ray.w), stepLength).x)) {
        return stepLength;
    }
    return clamp(distanceToFace(ray), kShortestStep * stepLength, stepLength);
}

// Moves the ray straight on, to the face of the domain at most; the length it went.
float drift(inout RayState ray, float ds) {
    vec3 moved = driftByLength(Ray(ray.x, ray.w), ds).x;
    float went = ds;
    if (outside(moved)) {
        went = min(distanceToFace(ray), ds);
        moved = clamp(driftByLength(Ray(ray.x, ray.w), went).x, domainMin, domainMax);
        ray.status = kExited;
    }
    ray.x = moved;
    return went;
}

// Evaluates the field where the ray is and turns it; the direction half way through the kick.
vec3 kick(inout RayState ray, float ds) {
    Optics optics = sampleOptics(ray.x);
    ray.evaluations += 1u;
    noteBend(ray, optics.gradN, ds);
#ifdef EFFECT_REFRACTION
    vec3 wMiddle = kickByLength(Ray(ray.x, ray.w), optics.gradN, 0.5 * ds).w;
    ray.w = kickByLength(Ray(ray.x, ray.w), optics.gradN, ds).w;
#else
    vec3 wMiddle = ray.w;
#endif
    followBoundary(ray, wMiddle, optics);
    ray.n = optics.n;
    return wMiddle / length(wMiddle);
}

// The second drift of the last step goes on to the face, which the turn has moved a little nearer or farther.
float lastDrift(inout RayState ray, float ds) {
    float toFace = distanceToFace(ray);
    return drift(ray, toFace < 2.0 * ds ? 1.001 * toFace + kShortestStep * stepLength : ds);
}

Step takeStep(inout RayState ray) {
    Step taken;
    float ds = nextStepLength(ray);
    taken.start = ray.x;
    taken.first = drift(ray, 0.5 * ds);
    taken.middle = ray.x;
    taken.second = 0.0;
    if (ray.status == kExited) {
        taken.direction = unitDirection(ray);
    } else {
        taken.direction = kick(ray, ds);
        taken.second = ds < stepLength ? lastDrift(ray, 0.5 * ds) : drift(ray, 0.5 * ds);
    }
    taken.end = ray.x;
    return taken;
}

// Matter is sampled at least once a voxel, whatever the step: once a step in its middle, or SAMPLES_PER_HALF times on each
// of its two pieces.
void passStep(inout RayState ray, Step taken) {
    ray.pathLength += taken.first + taken.second;
    ray.opticalLength += ray.n * (taken.first + taken.second);
#ifdef MATTER
#if SAMPLES_PER_HALF == 0
    vec3 x = taken.second > 0.0 ? taken.middle : 0.5 * (taken.start + taken.middle);
    passMatter(ray, x, taken.direction, ray.n, taken.first + taken.second);
#else
    for (int i = 0; i < 2 * SAMPLES_PER_HALF; ++i) {
        bool first = i < SAMPLES_PER_HALF;
        float share = (float(first ? i : i - SAMPLES_PER_HALF) + 0.5) / float(SAMPLES_PER_HALF);
        vec3 x = first ? mix(taken.start, taken.middle, share) : mix(taken.middle, taken.end, share);
        passMatter(ray, x, taken.direction, ray.n, (first ? taken.first : taken.second) / float(SAMPLES_PER_HALF));
    }
#endif
#endif
}

void endRay(inout RayState ray) {
    vec3 left = rayThroughput(ray);
    if (ray.status == kMarching && max(left.r, max(left.g, left.b)) < minThroughput) {
        ray.status = kAttenuated;
    }
    if (ray.status == kMarching && ray.evaluations + ray.lookUps >= maxEvaluations) {
        ray.status = kStepLimit;
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= rayCount || rays[index].status != kMarching) {
        return;
    }
    RayState ray = rays[index];
    stopInsideOpaque(ray);
    for (uint i = 0u; i < stepsPerSlice && ray.status == kMarching; ++i) {
        if (!fliesStraight(ray)) {
            Step taken = takeStep(ray);
            cutAtOpaque(ray, taken);
            passStep(ray, taken);
        }
        endRay(ray);
    }
    rays[index] = ray;
}

// Viewing rays through the domain, a slice of their steps: drift, kick, drift by arc length (physics/ray.glsl). The first
// and last drift are cut at the faces. Rays that have ended return at once.
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

bool outside(vec3 x) {
    return any(lessThan(x, domainMin)) || any(greaterThan(x, domainMax));
}

// Moves the ray straight on, to the face of the domain at most; the length it went.
float drift(inout RayState ray, float ds) {
    Ray moved = driftByLength(Ray(ray.x, ray.w), ds);
    float went = ds;
    if (outside(moved.x)) {
        vec3 direction = unitDirection(ray);
        went = min(distanceToExit(ray.x, direction, domainMin, domainMax), ds);
        moved.x = clamp(ray.x + direction * went, domainMin, domainMax);
        ray.status = kExited;
    }
    ray.x = moved.x;
    return went;
}

// Evaluates the field where the ray is and turns it; the direction half way through the kick.
vec3 kick(inout RayState ray) {
    Optics optics = sampleOptics(ray.x);
    ray.evaluations += 1u;
#ifdef EFFECT_REFRACTION
    vec3 wMiddle = kickByLength(Ray(ray.x, ray.w), optics.gradN, 0.5 * stepLength).w;
    ray.w = kickByLength(Ray(ray.x, ray.w), optics.gradN, stepLength).w;
#else
    vec3 wMiddle = ray.w;
#endif
    followBoundary(ray, wMiddle, optics);
    ray.n = optics.n;
    return wMiddle / length(wMiddle);
}

Step takeStep(inout RayState ray) {
    Step taken;
    taken.start = ray.x;
    taken.first = drift(ray, 0.5 * stepLength);
    taken.middle = ray.x;
    taken.second = 0.0;
    if (ray.status == kExited) {
        taken.direction = unitDirection(ray);
    } else {
        taken.direction = kick(ray);
        taken.second = drift(ray, 0.5 * stepLength);
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
    if (ray.status == kMarching && ray.evaluations >= maxEvaluations) {
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
        Step taken = takeStep(ray);
        cutAtOpaque(ray, taken);
        passStep(ray, taken);
        endRay(ray);
    }
    rays[index] = ray;
}

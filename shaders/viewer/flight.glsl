// Straight flights: where nothing bends a ray or stops it, it goes in one piece to where something may
// (docs/physics.md, section 1).
#include "shared/brick.h"

#ifndef MATTER_VOXELS
#define MATTER_VOXELS 1.0
#endif

#ifdef STRAIGHT_FLIGHTS

layout(binding = kUnitClearance) uniform sampler3D clearanceGrid;

// How far ahead [scene units] the ray's surroundings are alike.
struct Clearance {
    bool straight;  // nothing bends or stops the ray; else something may
    float reach;    // of which that holds
    float even;     // nor do matter or its light change; 0: they may
};

// Flights end this far inside the next brick, so that the next look-up is there.
const float kBeyondBrick = 1e-3;    // voxels
// Matter that varies is sampled every MATTER_VOXELS voxels, this often before the ray looks about again.
#ifdef INSETS
const int kSamplesPerFlight = 4;  // each has loops over insets, and a dispatch has few turns of loops
#else
const int kSamplesPerFlight = 16;
#endif

// Clearances are Chebyshev distances in bricks: the box that reaches so many bricks less one beyond x's own is free. It counts as
// a little larger, so that a ray that runs along a face of it, to rounding, is not held up there.
float distanceInClear(float bricks, vec3 brick, vec3 x, vec3 direction) {
    float edge = float(kBrickVoxels) * domain.voxel;
    float beyond = kBeyondBrick * domain.voxel;
    vec3 low = domain.min + (brick - (bricks - 1.0)) * edge;
    return distanceToExit(x, direction, low - beyond, low + (2.0 * bricks - 1.0) * edge + beyond);
}

// Outside the box of all that is not vacuum a ray goes to it, or away for ever.
Clearance clearanceAhead(vec3 x, vec3 direction) {
    BoxSpan content = boxSpan(x, direction, view.contentMin, view.contentMax);
    bool never = content.leave <= max(content.enter, 0.0);
    if (never || content.enter > 0.0) {
        float free = never ? 1.0e30 : content.enter;
        return Clearance(true, free, free);
    }
    ivec3 brick = ivec3(floor((x - domain.min) / (float(kBrickVoxels) * domain.voxel)));
    brick = clamp(brick, ivec3(0), textureSize(clearanceGrid, 0) - 1);
    vec2 bricks = round(255.0 * texelFetch(clearanceGrid, brick, 0).rg);
    float even = bricks.g > 0.0 ? distanceInClear(bricks.g, vec3(brick), x, direction) : 0.0;
    return Clearance(bricks.r > 0.0, distanceInClear(max(bricks.r, 1.0), vec3(brick), x, direction), even);
}

// What matter does along a straight piece, or the beginning of it; the length that was passed. Even matter takes one exact
// piece, and what varies one sample every MATTER_VOXELS.
float passAhead(inout RayState ray, vec3 direction, float ds, float even) {
#ifdef MATTER
    if (even > 0.0) {
        float passed = min(ds, even);
        passMatter(ray, ray.x + direction * (0.5 * passed), direction, ray.n, passed);
        return passed;
    }
    // flights go a little beyond bricks: samples stay a voxel apart, in step with the lattice
    const float kSlack = 0.01;
    int count = max(int(ceil(ds / (MATTER_VOXELS * domain.voxel) - kSlack)), 1);
    float piece = ds / float(count);
    int samples = min(count, kSamplesPerFlight);
    for (int i = 0; i < samples; ++i) {
        passMatter(ray, ray.x + direction * ((float(i) + 0.5) * piece), direction, ray.n, piece);
    }
    return samples == count ? ds : float(samples) * piece;
#else
    return ds;
#endif
}

// Moves the ray straight on, as far as `ahead` says and matter lets it.
void fly(inout RayState ray, vec3 direction, Clearance ahead) {
    float toFace = distanceToExit(ray.x, direction, domain.min, domain.max);
    float beyond = kBeyondBrick * domain.voxel;
    float went = passAhead(ray, direction, min(ahead.reach + beyond, toFace),
                           ahead.even > 0.0 ? ahead.even + beyond : 0.0);
    ray.x = clamp(ray.x + direction * went, domain.min, domain.max);
    ray.pathLength += went;
    ray.opticalLength += ray.n * went;
    ray.status = went >= toFace ? kExited : kMarching;
}

// Whether it is worth looking about: not where the ray has just been bent, is crossing a boundary, or knows already that it
// may be bent.
bool looksAhead(RayState ray) {
    return ray.pathLength >= ray.lookAgainAt && ray.crossingGradMax == 0.0;
}

bool mayFly(RayState ray, uint left) {
    return left > 0u && ray.status == kMarching && looksAhead(ray);
}

// Flies if nothing ahead is in the way, else notes how far that is known.
void look(inout RayState ray, inout uint left) {
    vec3 direction = unitDirection(ray);
    Clearance ahead = clearanceAhead(ray.x, direction);
    ray.lookUps += 1u;
    if (ahead.straight) {
        fly(ray, direction, ahead);
        left -= 1u;
    } else {
        ray.lookAgainAt = ray.pathLength + ahead.reach + kBeyondBrick * domain.voxel;
    }
    endRay(ray);
}

// Flights, at most `left` of them, until the ray is where it must step.
void flyAhead(inout RayState ray, inout uint left) {
    bool looks = mayFly(ray, left);
    do {
        if (looks) {
            look(ray, left);
        }
        looks = looks && mayFly(ray, left);
    } while (looks);
}

bool isBend(vec3 gradN) {
    return dot(gradN, gradN) > view.negligibleGradient * view.negligibleGradient;
}

// Steps of length ds before the ray's end is a place to look from, if none of them bends it.
uint stepsBeforeLook(RayState ray, float ds) {
    const float kMost = 1.0e9;
    return uint(clamp(ceil((ray.lookAgainAt - ray.pathLength) / ds), 0.0, kMost));
}

// Before what lies along a step of length ds is passed: where it bends the ray, its end is no place to look.
void noteBend(inout RayState ray, bool bends, float ds) {
    if (bends) {
        ray.lookAgainAt = max(ray.lookAgainAt, ray.pathLength + 1.01 * ds);
    }
}

#else

bool looksAhead(RayState ray) {
    return false;
}

bool isBend(vec3 gradN) {
    return false;
}

uint stepsBeforeLook(RayState ray, float ds) {
    return 0xffffffffu;
}

void flyAhead(inout RayState ray, inout uint left) {}
void noteBend(inout RayState ray, bool bends, float ds) {}

#endif

// Straight flights: where nothing bends a ray or stops it and matter is even, it goes in one piece to where something may change
// (docs/physics.md, section 1).
#include "shared/brick.h"

#ifdef STRAIGHT_FLIGHTS

layout(binding = kUnitClearance) uniform sampler3D clearanceGrid;

// How far ahead [scene units] the ray's surroundings are alike.
struct Clearance {
    bool straight;  // nothing bends or stops the ray, and matter is even; else nowhere so
    float reach;    // of which that holds
};

// Flights end this far inside the next brick, so that the next look-up is there.
const float kBeyondBrick = 1e-3;  // voxels

// Clearances are Chebyshev distances in bricks: the box that reaches so many bricks less one beyond x's own is alike. It counts as
// a little larger, so that a ray that runs along a face of it, to rounding, is not held up there.
float distanceAlike(float bricks, vec3 brick, vec3 x, vec3 direction) {
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
        return Clearance(true, never ? 1.0e30 : content.enter);
    }
    ivec3 brick = ivec3(floor((x - domain.min) / (float(kBrickVoxels) * domain.voxel)));
    brick = clamp(brick, ivec3(0), textureSize(clearanceGrid, 0) - 1);
    float bricks = round(255.0 * texelFetch(clearanceGrid, brick, 0).r) - float(kNoClearance);
    return Clearance(bricks > 0.0, distanceAlike(abs(bricks), vec3(brick), x, direction));
}

// Moves the ray straight on, as far as `ahead` says, through matter that is even.
void fly(inout RayState ray, vec3 direction, Clearance ahead) {
    float toFace = distanceToExit(ray.x, direction, domain.min, domain.max);
    float went = min(ahead.reach + kBeyondBrick * domain.voxel, toFace);
#ifdef MATTER
    passMatter(ray, ray.x + direction * (0.5 * went), direction, ray.n, went);
#endif
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

// Flies if nothing ahead is in the way, else notes up to where no look would find otherwise.
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

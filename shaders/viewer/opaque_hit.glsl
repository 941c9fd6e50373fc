// Where a viewing ray meets opaque matter.

#ifdef EFFECT_OPAQUE
#include "fields/opaque_path.glsl"

// The first place looked at that is solid, as a share of the step; 0: none. Steps beyond a voxel are looked at in their
// middle too.
float solidShareOf(Step taken) {
#if SAMPLES_PER_HALF > 0
    if (isSolid(taken.middle)) {
        return 0.5;
    }
#endif
    return isSolid(taken.end) ? 1.0 : 0.0;
}

bool meetsOpaque(Step taken) {
    return solidShareOf(taken) > 0.0;
}

// Ends the ray and the step where the step meets matter.
void cutAtOpaque(inout RayState ray, inout Step taken) {
    float solidShare = solidShareOf(taken);
    if (solidShare == 0.0) {
        return;
    }
    float share = shareOfHit(taken.start, taken.middle, taken.end, solidShare);
    ray.x = pointOfPath(taken.start, taken.middle, taken.end, share);
    ray.status = kHitOpaque;
    taken.end = ray.x;
    taken.middle = share < 0.5 ? ray.x : taken.middle;
    taken.first *= min(2.0 * share, 1.0);
    taken.second *= max(2.0 * share - 1.0, 0.0);
}

// A ray that enters the domain, or starts, inside opaque matter ends there.
void stopInsideOpaque(inout RayState ray) {
    if (isSolid(ray.x)) {
        ray.status = kHitOpaque;
    }
}

#else

bool meetsOpaque(Step taken) {
    return false;
}

void cutAtOpaque(inout RayState ray, inout Step taken) {}
void stopInsideOpaque(inout RayState ray) {}

#endif

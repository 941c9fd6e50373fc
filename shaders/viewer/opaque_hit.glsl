// Where a viewing ray meets opaque matter: where its coverage crosses one half.

const float kSolid = 0.5;
const int kBisections = 12;

#ifdef EFFECT_OPAQUE

bool isSolid(vec3 x) {
    return sampleOpaque(x).a >= kSolid;
}

// A point of the step, share 0 its start, 1/2 its middle, 1 its end.
vec3 pointOfStep(Step taken, float share) {
    return share < 0.5 ? mix(taken.start, taken.middle, 2.0 * share)
                       : mix(taken.middle, taken.end, 2.0 * share - 1.0);
}

float shareOfHit(Step taken, float solidShare) {
    float free = 0.0;
    float solid = solidShare;
    for (int i = 0; i < kBisections && solidShare > 0.0; ++i) {
        float middle = 0.5 * (free + solid);
        if (isSolid(pointOfStep(taken, middle))) {
            solid = middle;
        } else {
            free = middle;
        }
    }
    return solid;
}

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
    float share = shareOfHit(taken, solidShare);
    ray.x = pointOfStep(taken, share);
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

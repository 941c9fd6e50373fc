// Rays that are followed from a mirror on: from the source as ever, reflected where the path that is followed has a mirror,
// and counted from the last of them (docs/physics.md, section 3). And what all rays lose by reflection, crossing by crossing.
// A ray before its last mirror is where its image is: on the straight line on which the reflected ray seems to come, so that
// neighbours which have passed the mirror and which have not can be compared and interpolated between.

layout(std430, binding = TUBE_REFLECTIONS_BINDING) buffer ReflectionBlock { TubeReflections reflections[]; };

// Contrast (n1 - n2)/(n1 + n2) from which a Fresnel term is a mirror's. The plateau at which a crossing ends leaves 0.3 % of the
// step to a piece of its own, which must not be counted: in glass that is a contrast of 0.0008.
const float kLeastContrast = 0.003;

// Index beyond the boundary that a step has left.
float indexBeyond(Particle before, Particle after) {
    return before.sideAtStart > 0.0 ? max(before.nLast, after.nLast) : min(before.nLast, after.nLast);
}

// Whether a Fresnel term took effect in a step.
bool reflectsBetween(Particle before, Particle after) {
    float beyond = indexBeyond(before, after);
    return after.throughputS < before.throughputS &&
           abs(beyond - before.nStart) > kLeastContrast * (beyond + before.nStart);
}

// Whether a boundary under way before a step is the one that is under way after it.
bool isSameCrossing(Particle before, Particle after) {
    return before.gradMax > 0.0 && after.gradMax >= before.gradMax &&
           dot(after.normal, before.normal) > kPlateau * length(after.normal) * length(before.normal);
}

// Number of the crossing that mirror number `mirror` of the path is, from the mirror before it.
uint crossingOfMirror(uint mirror) {
    return (tube.mirrors >> (mirror * TUBE_MIRROR_BITS) & ((1u << TUBE_MIRROR_BITS) - 1u)) + 1u;
}

struct Start {
    Particle ray;
    float path;  // optical path there
};

// Follows a ray to where the index passes a level, towards denser matter (side +1) or thinner (-1): regula falsi.
Start atLevel(Start start, float level, float side, inout uint evaluations) {
    const int kMostSteps = 64;   // a boundary is a few voxels wide
    const int kCorrections = 4;  // within a step the index is nearly linear: the second leaves 0.001 of one
    Start at = start;
    if (at.ray.status == PARTICLE_WAITING) {
        float straight = max(at.ray.enterPath - at.path, 0.0);
        at = Start(enterDomain(at.ray, at.ray.x + at.ray.w * straight), at.path + straight);
    }
    float missing = side * (level - sampleOptics(at.ray.x).n);
    float dt = settings.opticalStep;
    float beyond = 0.0;    // what is missing at `far`
    float far = -1.0;      // optical path of a place beyond the level, once one is known
    int corrections = 0;
    Start reached = at;
    for (int i = 0; i < kMostSteps && corrections < kCorrections; ++i) {
        Particle next = advanceInside(at.ray, dt);
        float rest = side * (level - sampleOptics(next.x).n);
        evaluations += 2u;
        reached = Start(next, at.path + dt);
        if (rest > 0.0) {
            at = reached;
            missing = rest;
        } else {
            far = reached.path;
            beyond = rest;
        }
        if (far >= 0.0) {
            dt = (far - at.path) * missing / max(missing - beyond, 1.0e-30);
            ++corrections;
        }
    }
    return reached;
}

// The ray that a crossing reflects: `start`, where it was when the crossing began; the step in which it ended, from `before`
// to `after`. The mirror is the surface on which the index is the mean of both sides': there it changes most.
Particle mirrored(Start start, Particle before, Particle after, inout uint evaluations) {
    float side = before.sideAtStart;
    Start at = atLevel(start, 0.5 * (before.nStart + indexBeyond(before, after)), side, evaluations);
    Particle ray = at.ray;
    vec3 gradN = sampleOptics(ray.x).gradN;
    ray.normal = gradN / max(length(gradN), 1.0e-30);
    ray.gradMax = max(length(gradN), before.gradMax);
    vec3 tangential = ray.w - ray.normal * dot(ray.w, ray.normal);
    ray.nStart = before.nStart;
    ray.weight = 1.0;
    ray.along = length(tangential);
    ray.sideAtStart = side;
    Crossing crossing = Crossing(ray.normal, 1.0, ray.along, ray.gradMax, ray.nStart, ray.nLast, side);
    vec3 farWave = crossingReflected(crossing, ray.w);
    ray.status = PARTICLE_MIRRORED;
    ray.w = farWave / max(dot(farWave, farWave), 1.0e-30);
    ray.enterPath = at.path;
#ifdef EFFECT_TINT
    ray.transmittance *= before.tint;
#endif
    ray.throughputS = before.throughputS - after.throughputS;
    ray.throughputP = before.throughputP - after.throughputP;
    return ray;
}

// The same ray without what it did so far.
Particle withoutHistory(Particle ray) {
    Particle fresh = ray;
    fresh.enteredShare = 0.0;
    fresh.absorbedShare = vec3(0.0);
    fresh.scatteredShare = vec3(0.0);
    fresh.reflectedShare = vec3(0.0);
    fresh.tintedShare = vec3(0.0);
    return fresh;
}

// The same ray where it, or its image, was at optical path 0; without a share if it never meets the mirrors.
Particle atSource(Particle ray, float path, bool isMirrored) {
    Particle source = withoutHistory(ray);
    if (!isMirrored) {
        source.status = PARTICLE_MISSED;
        source.launchShare = 0.0;
        source.w = ray.w / dot(ray.w, ray.w);
    }
    source.x = ray.x - source.w * path;
    return source;
}

void beginReflections(uint self) {
    reflections[self].crossings = 0u;
    for (int i = 0; i < TUBE_CROSSINGS; ++i) {
        reflections[self].shares[i] = 0.0;
    }
}

// A ray on its way to its mirrors.
struct MirrorPath {
    Particle ray;
    uint stepCount;
    uint mirrors;    // so far
    uint crossings;  // since the last of them
    Start start;     // of the crossing under way
};

// The ray makes a step, unless it ends the crossing that is the next mirror: true.
bool meetsMirror(inout MirrorPath path, Particle after) {
    bool reflects = reflectsBetween(path.ray, after);
    path.crossings += reflects ? 1u : 0u;
    if (reflects && path.crossings == crossingOfMirror(path.mirrors)) {
        return true;
    }
    if (!isSameCrossing(path.ray, after)) {
        path.start = Start(path.ray, pathAt(path.stepCount));
    }
    path.ray = after;
    ++path.stepCount;
    return false;
}

// The ray leaves the mirror that it has met.
void leave(inout MirrorPath path, Particle after, inout uint evaluations) {
    Particle ray = mirrored(path.start, path.ray, after, evaluations);
    path.stepCount = uint(max(ray.enterPath, 0.0) / settings.opticalStep);
    ray.x -= ray.w * (ray.enterPath - pathAt(path.stepCount));
    path.ray = ray;
    path.crossings = 0u;
    ++path.mirrors;
    path.start = Start(ray, pathAt(path.stepCount));
}

bool goesOn(MirrorPath path) {
    return path.mirrors < tube.mirrorCount && path.stepCount < settings.maxSteps && path.ray.status <= PARTICLE_INSIDE;
}

// Ray number `self` on the path that is followed, at optical path 0.
Particle launched(uint self, inout uint evaluations) {
    beginReflections(self);
    Particle ray = particleAtLaunch(frames[vertices[self].frameIndex], vertices[self].launch);
    MirrorPath path = MirrorPath(ray, 0u, 0u, 0u, Start(ray, 0.0));
    while (goesOn(path)) {
        while (goesOn(path) && fliesFree(path.ray, path.stepCount)) {
            path.ray = fly(path.ray);
            ++path.stepCount;
        }
        Particle after = path.ray;
        bool meets = false;
        bool plain = path.ray.status == PARTICLE_INSIDE;
        while (goesOn(path) && plain && !meets) {
            plain = isPlainStep(path.ray, after, evaluations);
            if (plain) {
                meets = meetsMirror(path, after);
            }
        }
        if (goesOn(path) && !meets && !fliesFree(path.ray, path.stepCount)) {
            after = stepped(path.ray, path.stepCount, evaluations);
            meets = meetsMirror(path, after);
        }
        if (meets) {
            leave(path, after, evaluations);
        }
    }
    return tube.mirrorCount > 0u ? atSource(path.ray, pathAt(path.stepCount), path.mirrors == tube.mirrorCount) : ray;
}

// Enters what a step of ray number `self` lost by reflection.
void countReflection(uint self, Particle before, Particle after) {
    uint crossing = reflections[self].crossings;
    if (reflectsBetween(before, after) && crossing < uint(TUBE_CROSSINGS)) {
        reflections[self].shares[crossing] = largestOf(after.reflectedShare - before.reflectedShare);
        reflections[self].crossings = crossing + 1u;
    }
}

// Whether what the ray carries is on its way through the domain or close to it: an image is not.
bool isNear(Particle ray) {
    return ray.status != PARTICLE_MIRRORED && withinDomain(ray.x, tube.nearMargin);
}

// Steps since the ray's last mirror, negative before it.
float stepsSinceMirror(Particle ray, uint stepCount) {
    return tube.mirrorCount == 0u || ray.status == PARTICLE_MISSED
               ? 0.0
               : float(stepCount) - ray.enterPath / settings.opticalStep;
}

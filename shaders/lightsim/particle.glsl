// One corner particle: launched at the source, advanced by constant steps of optical path.
// The same lines run in emit, propagate and refine, so that a ray traced anew from the source repeats the old one.
#include "fields/fields.glsl"
#include "lightsim/share.glsl"
#include "physics/ray.glsl"
#include "physics/box.glsl"
#include "physics/launch.glsl"
#include "physics/fresnel.glsl"
#include "physics/boundary.glsl"
#include "physics/attenuation.glsl"
#include "physics/profile.glsl"

#ifdef EFFECT_OPAQUE
#include "fields/opaque_path.glsl"
#endif

float launchShareOf(LaunchFrame frame, vec3 direction) {
    if (frame.profile == PROFILE_CONE) {
        return coneShare(direction, frame.profileAxis, frame.coneInner, frame.coneOuter);
    }
    if (frame.profile == PROFILE_COSINE) {
        return cosineShare(direction, frame.profileAxis);
    }
    return 1.0;
}

Particle particleAtLaunch(LaunchFrame frame, vec2 launch) {
    Particle particle;
    vec3 offset = frame.a * launch.x + frame.b * launch.y;
    bool isPoint = frame.isPoint != 0u;
    LaunchLine line = launchLine(isPoint, frame.origin, frame.centre, frame.axis, offset);
    vec3 direction = line.direction;
    float targetPath = frame.phase;  // optical path at the target
    if (isPoint) {
        // |axis + offset| - |axis| without cancellation: frames are built with offset perpendicular to axis
        targetPath += dot(offset, offset) / (line.sourceDistance + length(frame.axis));
    }
    BoxSpan span = boxSpan(line.target, direction, domain.min, domain.max);
    particle.status = meetsDomain(line, span) ? PARTICLE_WAITING : PARTICLE_MISSED;
    particle.enterPath = max(targetPath + span.enter, 0.0);  // 0: the source is inside
    particle.x = line.target - direction * targetPath;
    particle.w = direction;
    particle.xPrevious = particle.x;
    particle.throughputS = 1.0;
    particle.throughputP = 1.0;
    particle.transmittance = vec3(1.0);
    particle.launchShare = launchShareOf(frame, direction);
    particle.meanShare = vec3(particle.launchShare);
    particle.enteredShare = 0.0;
    particle.normal = vec3(0.0);
    particle.gradMax = 0.0;
    particle.nStart = 1.0;
    particle.nLast = 1.0;
    particle.along = 0.0;
    particle.sideAtStart = 0.0;
    particle.absorbedShare = vec3(0.0);
    particle.scatteredShare = vec3(0.0);
    particle.reflectedShare = vec3(0.0);
    particle.arcLength = 0.0;
    particle.litPart = 1.0;
    particle.tint = vec3(1.0);
    particle.weight = 0.0;
    particle.tintedShare = vec3(0.0);
    particle.blockedAt = 0.0;
    return particle;
}

Particle enterDomain(Particle particle, vec3 entry) {
    Particle inside = particle;
    float n = sampleOptics(entry).n;
    inside.x = entry;
    inside.w = particle.w * n;
    inside.status = PARTICLE_INSIDE;
    inside.enteredShare = particle.launchShare;
    inside.nLast = n;
    return inside;
}

#ifdef FOLLOW_REFLECTIONS
// The particle leaves its last mirror, the middle of a boundary: the component along the boundary is that of the reflected
// ray far from it, the one across is what the index leaves.
Particle leaveMirror(Particle particle) {
    Particle inside = particle;
    float n = sampleOptics(particle.x).n;
    vec3 farWave = particle.w / dot(particle.w, particle.w);
    vec3 tangential = farWave - particle.normal * dot(farWave, particle.normal);
    float normalPart = sqrt(max(n * n - dot(tangential, tangential), 0.0));
    inside.w = tangential - particle.normal * (particle.sideAtStart * normalPart);
    inside.sideAtStart = 0.0;  // the rest of this boundary is no crossing (physics/boundary.glsl)
    inside.status = PARTICLE_INSIDE;
    inside.nLast = n;
    return inside;
}
#endif

// Medium along a straight piece inside the domain, from its midpoint: exact for constant extinction.
Particle attenuate(Particle particle, vec3 midpoint, float arcLength) {
    Particle after = particle;
    vec3 before = remainingShare(particle);
    after.meanShare = before;
#if defined(EFFECT_ABSORPTION) || defined(EFFECT_SCATTERING)
    vec3 sigmaA = vec3(0.0);
    vec3 sigmaS = vec3(0.0);
#ifdef EFFECT_ABSORPTION
    sigmaA = sampleSigmaA(midpoint);
#endif
#ifdef EFFECT_SCATTERING
    sigmaS = sampleSigmaS(midpoint).rgb;
#endif
    vec3 tau = (sigmaA + sigmaS) * arcLength;
    vec3 meanOverStep = meanTransmittance3(tau);
    after.meanShare = before * meanOverStep;
    after.absorbedShare = particle.absorbedShare + after.meanShare * sigmaA * arcLength;
    after.scatteredShare = particle.scatteredShare + after.meanShare * sigmaS * arcLength;
    after.transmittance = particle.transmittance * (1.0 - tau * meanOverStep);
#endif
    return after;
}

// What boundaries take of a loss by reflection, and what they reflect.
Particle splitLoss(Particle particle, vec3 loss) {
    Particle after = particle;
#ifdef EFFECT_TINT
    after.reflectedShare = particle.reflectedShare + loss * particle.tint;
    after.tintedShare = particle.tintedShare + loss * (1.0 - particle.tint);
#else
    after.reflectedShare = particle.reflectedShare + loss;
#endif
    return after;
}

// Fresnel loss where the step has left an interface (physics/boundary.glsl).
Particle crossInterfaces(Particle particle, vec3 x, vec3 w, float n, vec3 gradN) {
    Particle after = particle;
#ifdef EFFECT_REFLECTION
    Crossing crossing;
    crossing.normal = particle.normal;
    crossing.gradMax = particle.gradMax;
    crossing.nStart = particle.nStart;
    crossing.nLast = particle.nLast;
    crossing.weight = particle.weight;
    crossing.along = particle.along;
    crossing.sideAtStart = particle.sideAtStart;
    bool inBand = inInterface(x);
    if (crossingEnds(crossing, inBand, gradN)) {
        Polarised transmittance = crossingTransmittance(crossing, w, crossingEndIndex(crossing, inBand, n));
        after.throughputS = particle.throughputS * transmittance.s;
        after.throughputP = particle.throughputP * transmittance.p;
        after = splitLoss(after, particle.launchShare * particle.transmittance * (throughputOf(particle) - throughputOf(after)));
    }
    crossing = crossingAfter(crossing, inBand, w, n, gradN);
#ifdef EFFECT_TINT
    if (crossing.gradMax != particle.gradMax) {
        after.tint = surfaceAt(x).rgb;
    }
#endif
    after.normal = crossing.normal;
    after.gradMax = crossing.gradMax;
    after.nStart = crossing.nStart;
    after.nLast = crossing.nLast;
    after.weight = crossing.weight;
    after.along = crossing.along;
    after.sideAtStart = crossing.sideAtStart;
#endif
    return after;
}

// Both pieces of a step, and between them, where the field is looked at, what boundaries reflect: the share is then the mean
// of what it is before and after. Where n changes the pieces differ in length: the matter at the place where they meet would
// stand for too much of the slower one.
Particle passStep(Particle particle, vec3 start, vec3 middle, vec3 end, vec3 w, Optics optics) {
    float first = length(middle - start);
    float second = length(end - middle);
    Particle halfWay = attenuate(particle, 0.5 * (start + middle), first);
    Particle after = crossInterfaces(halfWay, middle, w, optics.n, optics.gradN);
    after = attenuate(after, 0.5 * (middle + end), second);
    after.meanShare = (halfWay.meanShare * first + after.meanShare * second) / max(first + second, 1.0e-30);
    after.arcLength = particle.arcLength + first + second;
    return after;
}

bool insideDomain(vec3 x) {
    return all(greaterThanEqual(x, domain.min)) && all(lessThanEqual(x, domain.max));
}

// The particle leaves through a face of the domain: the medium acts up to the face, beyond it the ray is straight.
Particle leaveDomain(Particle particle, Ray before, Ray end) {
    vec3 along = end.x - before.x;
    float reach = length(along);
    float inside = min(distanceToExit(before.x, along / max(reach, 1.0e-30), domain.min, domain.max), reach);
    Particle after = attenuate(particle, before.x + along * (0.5 * inside / max(reach, 1.0e-30)), inside);
    after.status = PARTICLE_EXITED;
    after.arcLength = particle.arcLength + reach;
    after.x = end.x;
    after.w = normalize(end.w);
    return after;
}

#ifdef EFFECT_OPAQUE
// Share of a step at which it meets opaque matter; 1: it does not, or at its very end.
float freeShareOf(vec3 start, vec3 middle, vec3 end) {
    float solidShare = isSolid(middle) ? 0.5 : 1.0;
    return isSolid(solidShare < 1.0 ? middle : end) ? shareOfHit(start, middle, end, solidShare) : 1.0;
}

// The particle ends where the step meets opaque matter. Its place goes on, so that the front stays whole.
Particle meetMatter(Particle particle, vec3 start, vec3 middle, Ray end, float freeShare, vec3 w, Optics optics) {
    vec3 hit = pointOfPath(start, middle, end.x, freeShare);
    Particle after = passStep(particle, start, freeShare < 0.5 ? hit : middle, hit, w, optics);
    float litLength = after.arcLength;
    after.arcLength = particle.arcLength + length(middle - start) + length(end.x - middle);
    after.litPart = litLength / max(after.arcLength, 1.0e-30);
    after.meanShare *= after.litPart;
    after.status = PARTICLE_BLOCKED;
    after.x = end.x;
    after.w = normalize(end.w);
    return after;
}
#endif

// Drift-kick-drift over some optical path; one field evaluation.
struct InnerStep {
    Ray before, end;
    vec3 middle;
    vec3 w;         // mean of both ends'
    Optics optics;  // in the middle
};

InnerStep stepInside(Particle particle, float dt) {
    InnerStep inner;
    inner.before.x = particle.x;
    inner.before.w = particle.w;
    Ray middle = driftByOpticalPath(inner.before, 0.5 * dt);
    inner.middle = middle.x;
    inner.optics = sampleOptics(middle.x);
    inner.end = driftByOpticalPath(kickByOpticalPath(middle, inner.optics.n, inner.optics.gradN, dt), 0.5 * dt);
    inner.w = 0.5 * (inner.before.w + inner.end.w);
    return inner;
}

// Whether the step ends inside the domain, in front of opaque matter.
bool isPlain(InnerStep inner) {
#ifdef EFFECT_OPAQUE
    if (isSolid(inner.middle) || isSolid(inner.end.x)) {
        return false;
    }
#endif
    return insideDomain(inner.end.x);
}

Particle passPlain(Particle particle, InnerStep inner) {
    Particle after = passStep(particle, inner.before.x, inner.middle, inner.end.x, inner.w, inner.optics);
    after.x = inner.end.x;
    after.w = inner.end.w;
    return after;
}

// A step inside the domain, whatever comes in its way.
Particle advanceInside(Particle particle, float dt) {
    InnerStep inner = stepInside(particle, dt);
#ifdef EFFECT_OPAQUE
    float freeShare = freeShareOf(inner.before.x, inner.middle, inner.end.x);
    if (freeShare < 1.0) {
        return meetMatter(particle, inner.before.x, inner.middle, inner.end, freeShare, inner.w, inner.optics);
    }
#endif
    if (!insideDomain(inner.end.x)) {
        return leaveDomain(particle, inner.before, inner.end);
    }
    return passPlain(particle, inner);
}

// Whether the step from optical path t on leads straight through empty space: no field is looked at.
bool fliesFree(Particle particle, float t) {
    bool waits = particle.status == PARTICLE_WAITING || particle.status == PARTICLE_MIRRORED;
    return waits ? particle.enterPath >= t + settings.opticalStep : particle.status != PARTICLE_INSIDE;
}

// Such a step.
Particle fly(Particle particle) {
    Particle after = particle;
    after.xPrevious = particle.x;
    after.x = particle.x + particle.w * settings.opticalStep;
    after.arcLength = settings.opticalStep * length(particle.w);
#ifdef EFFECT_OPAQUE
    if (particle.status == PARTICLE_BLOCKED) {
        after.litPart = 0.0;
        after.meanShare = vec3(0.0);
    }
#endif
    return after;
}

Particle atStepStart(Particle particle) {
    Particle start = particle;
    start.xPrevious = particle.x;
    start.arcLength = 0.0;
    return start;
}

// Any other: in the first one the particle enters the domain, or leaves its last mirror.
Particle passFields(Particle particle, float t) {
    Particle start = atStepStart(particle);
    float dt = settings.opticalStep;
    float straight = clamp(particle.enterPath - t, 0.0, dt);
    if (particle.status == PARTICLE_WAITING) {
        start = enterDomain(start, particle.x + particle.w * straight);
        start.arcLength = straight;
        dt -= straight;
    }
#ifdef FOLLOW_REFLECTIONS
    if (particle.status == PARTICLE_MIRRORED) {
        start.x = particle.x + particle.w * straight;
        start.arcLength = straight * length(particle.w);
        start = leaveMirror(start);
        dt -= straight;
    }
#endif
    return advanceInside(start, dt);
}

// One step of optical path, whatever the particle is doing; t: optical path at the start of the step.
Particle advance(Particle particle, float t) {
    if (fliesFree(particle, t)) {
        return fly(particle);
    }
    return passFields(particle, t);
}

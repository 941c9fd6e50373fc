// Trace: every listed vertex follows its ray through the window. New ones are launched at the source and brought to the
// window's beginning first, so every vertex is an exact ray.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/tracks.glsl"
#include "lightsim/particle.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_VERTICES_BINDING) buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };
layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { uint listed[]; };
layout(std430, binding = TUBE_RESULTS_BINDING) buffer ResultBlock {
    uint evaluationsLow;
    uint evaluationsHigh;
    uint padA;
    uint padB;
    TubePresence presences[];
};

void countEvaluations(uint evaluations) {
    uint before = atomicAdd(evaluationsLow, evaluations);
    if (before + evaluations < before) {
        atomicAdd(evaluationsHigh, 1u);
    }
}

Particle stepped(Particle ray, uint stepCount, inout uint evaluations) {
    Particle after = advance(ray, float(stepCount) * settings.opticalStep);
    if (after.status == PARTICLE_BLOCKED && ray.status != PARTICLE_BLOCKED) {
        after.blockedAt = float(stepCount) + after.litPart;
    }
    evaluations += after.status == PARTICLE_INSIDE ? 1u : 0u;
    return after;
}

#ifdef FOLLOW_REFLECTIONS
#include "lightsim/tubes/mirrors.glsl"
#else
Particle launched(uint self, inout uint evaluations) {
    return particleAtLaunch(frames[vertices[self].frameIndex], vertices[self].launch);
}

void countReflection(uint self, Particle before, Particle after) {}

// Whether what the ray carries is on its way through the domain or close to it.
bool isNear(Particle ray) {
    return withinDomain(ray.x, tube.nearMargin);
}

// Steps since the ray's last mirror; negative before it.
float stepsSinceMirror(Particle ray, uint stepCount) {
    return 0.0;
}
#endif

// What is left where the last step, or its part in front of opaque matter, ends.
vec3 shareLeft(Particle ray) {
    return ray.litPart > 0.0 ? remainingShare(ray) : vec3(0.0);
}

// Arc length of the last step, in the step that meets opaque matter as far as that. Behind it only the share is 0.
float litArcOf(Particle ray) {
    return ray.litPart > 0.0 ? ray.arcLength * ray.litPart : ray.arcLength;
}

// Whether a step may not be joined with the one before it to a longer one. A turn by the angle a in each of three steps of a
// voxel leaves their chord 9/8 a voxels off: less than middles may deviate. In one medium a share that falls by less than a
// tenth falls as an exponential all along; where the index changes, matter may too.
bool isBent(Particle before, Particle after) {
    const float kMostTurn = 0.06;
    const float kSameShare = 0.1;
    const float kSameShareInTurn = 0.01;
    vec3 left = shareLeft(before);
    float mostLoss = after.w == before.w ? kSameShare : kSameShareInTurn;
    bool changed = largestOf(left - shareLeft(after)) > mostLoss * largestOf(left);
    return length(after.w - before.w) > kMostTurn * length(before.w) || after.status != before.status || changed;
}

void record(uint place, Particle ray, uint stepCount) {
    positions[place] = vec4(ray.x, litArcOf(ray));
    shares[place] = vec4(shareLeft(ray), stepsSinceMirror(ray, stepCount));
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    uint self = listed[index];
    uint track = trackOf(self);
    uint stepCount = vertices[self].stepCount;
    uint evaluations = 0u;
    Particle ray = vertices[self].ray;
    if (stepCount == TUBE_NOT_LAUNCHED) {
        ray = launched(self, evaluations);
        for (stepCount = 0u; stepCount < tube.firstStep; ++stepCount) {
            Particle before = ray;
            ray = stepped(ray, stepCount, evaluations);
            countReflection(self, before, ray);
        }
        record(track, ray, stepCount);
    } else {
        // where the front of the window before was made to conform, this one begins
        positions[track] = positionAt(track + uint(TUBE_STEPS));
        shares[track] = shareAt(track + uint(TUBE_STEPS));
    }
    TubePresence presence = TubePresence(uvec2(0u), uvec2(0u), 0u, 0.0, 0u, 0u);
    bool nearBefore = isNear(ray);
    for (int k = 0; k < TUBE_STEPS; ++k) {
        Particle before = ray;
        ray = stepped(ray, stepCount, evaluations);
        countReflection(self, before, ray);
        ++stepCount;
        if (isBent(before, ray)) {
            presence.bent |= sampleBit(k);
        }
        record(track + uint(k + 1), ray, stepCount);
        bool nearNow = isNear(ray);
        if (nearBefore || nearNow) {
            presence.near |= sampleBit(k);
        }
        nearBefore = nearNow;
    }
    presence.ended = ray.status == PARTICLE_BLOCKED || (ray.status >= PARTICLE_EXITED && !nearBefore &&
                     dot(ray.w, 0.5 * (domain.min + domain.max) - ray.x) < 0.0) ? 1u : 0u;
    bool goesOn = ray.status <= PARTICLE_INSIDE || (nearBefore && ray.status != PARTICLE_BLOCKED);
    presence.remaining = goesOn ? largestOf(shareLeft(ray)) : 0.0;
    presences[self] = presence;
    vertices[self].ray = ray;
    vertices[self].stepCount = stepCount;
    countEvaluations(evaluations);
}

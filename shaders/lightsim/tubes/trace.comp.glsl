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

float pathAt(uint stepCount) {
    return float(stepCount) * settings.opticalStep;
}

// Rays go on in loops of three kinds, for the software renderer runs both sides of every branch, but ends a loop where no ray of a
// vector goes on: steps through empty space look at no field; plain steps at each once; and those in which something happens, which
// are few, may look many times.

bool fliesFree(Particle ray, uint stepCount) {
    return fliesFree(ray, pathAt(stepCount));
}

// A step that begins after so many, if it is a plain one.
bool isPlainStep(Particle ray, out Particle after, inout uint evaluations) {
    InnerStep inner = stepInside(ray, settings.opticalStep);
    evaluations += 1u;
    after = passPlain(atStepStart(ray), inner);
    return isPlain(inner);
}

// Any other step through fields.
Particle stepped(Particle ray, uint stepCount, inout uint evaluations) {
    Particle after = passFields(ray, pathAt(stepCount));
    if (after.status == PARTICLE_BLOCKED) {
        after.blockedAt = float(stepCount) + after.litPart;
    }
    evaluations += 1u;
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

// What a step takes of the light that is left, by band, over that of the strongest.
vec3 lossOf(Particle before, Particle after) {
    vec3 left = shareLeft(before);
    return (left - shareLeft(after)) / max(largestOf(left), 1.0e-30);
}

// Whether a step may not be joined with the one before it, which lost `lossBefore`, to a longer one. A turn by the angle a in each
// of three steps of a voxel leaves their chord 9/8 a voxels off: less than middles may deviate. Where matter takes up the same from
// step to step, a share that falls by less than a tenth falls as an exponential all along.
bool isBent(Particle before, Particle after, vec3 loss, vec3 lossBefore) {
    const float kMostTurn = 0.06;
    const float kMostLoss = 0.1;
    const float kSameLoss = 0.005;
    return length(after.w - before.w) > kMostTurn * length(before.w) || after.status != before.status ||
           largestOf(loss) > kMostLoss || largestOf(abs(loss - lossBefore)) > kSameLoss;
}

void record(uint place, Particle ray, uint stepCount) {
    positions[place] = vec4(ray.x, litArcOf(ray));
    recordShare(place, vec4(shareLeft(ray), stepsSinceMirror(ray, stepCount)));
}

// A ray on its way through the window, and what is noted of it.
struct Trace {
    uint self;
    Particle ray;
    uint stepCount;
    TubePresence presence;
    bool nearBefore;
    vec3 lossBefore;
};

// The ray has made a step. Before the window begins nothing is noted but what it loses by reflection.
void goOn(inout Trace trace, Particle after) {
    Particle before = trace.ray;
    countReflection(trace.self, before, after);
    trace.ray = after;
    ++trace.stepCount;
    if (trace.stepCount < tube.firstStep) {
        return;
    }
    int sampleIndex = int(trace.stepCount - tube.firstStep);
    record(trackOf(trace.self) + uint(sampleIndex), after, trace.stepCount);
    bool nearNow = isNear(after);
    vec3 loss = lossOf(before, after);
    if (sampleIndex > 0) {
        uvec2 bit = sampleBit(sampleIndex - 1);
        if (isBent(before, after, loss, sampleIndex == 1 ? loss : trace.lossBefore)) {
            trace.presence.bent |= bit;
        }
        if (trace.nearBefore || nearNow) {
            trace.presence.near |= bit;
        }
    }
    trace.nearBefore = nearNow;
    trace.lossBefore = loss;
}

void follow(inout Trace trace, uint lastStep, inout uint evaluations) {
    while (trace.stepCount < lastStep) {
        while (trace.stepCount < lastStep && fliesFree(trace.ray, trace.stepCount)) {
            goOn(trace, fly(trace.ray));
        }
        bool plain = trace.ray.status == PARTICLE_INSIDE;
        while (trace.stepCount < lastStep && plain) {
            Particle after;
            plain = isPlainStep(trace.ray, after, evaluations);
            if (plain) {
                goOn(trace, after);
            }
        }
        if (trace.stepCount < lastStep && !fliesFree(trace.ray, trace.stepCount)) {
            goOn(trace, stepped(trace.ray, trace.stepCount, evaluations));
        }
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    uint self = listed[index];
    uint track = trackOf(self);
    uint evaluations = 0u;
    Trace trace = Trace(self, vertices[self].ray, vertices[self].stepCount,
                        TubePresence(uvec2(0u), uvec2(0u), 0u, 0.0, 0u, 0u), false, vec3(0.0));
    if (trace.stepCount == TUBE_NOT_LAUNCHED) {
        trace.ray = launched(self, evaluations);
        trace.stepCount = 0u;
        if (tube.firstStep == 0u) {
            record(track, trace.ray, 0u);
        }
    } else {
        // where the front of the window before was made to conform, this one begins
        positions[track] = positionAt(track + uint(TUBE_STEPS));
        recordShare(track, shareAt(track + uint(TUBE_STEPS)));
    }
    trace.nearBefore = isNear(trace.ray);
    follow(trace, tube.firstStep + uint(TUBE_STEPS), evaluations);
    Particle ray = trace.ray;
    bool isNearNow = trace.nearBefore;
    TubePresence presence = trace.presence;
    presence.ended = ray.status == PARTICLE_BLOCKED || (ray.status >= PARTICLE_EXITED && !isNearNow &&
                     dot(ray.w, 0.5 * (domain.min + domain.max) - ray.x) < 0.0) ? 1u : 0u;
    bool goesOn = ray.status <= PARTICLE_INSIDE || (isNearNow && ray.status != PARTICLE_BLOCKED);
    presence.remaining = goesOn ? largestOf(shareLeft(ray)) : 0.0;
    presences[self] = presence;
    vertices[self].ray = ray;
    vertices[self].stepCount = trace.stepCount;
    countEvaluations(evaluations);
}

// Split: a patch that refine has listed becomes two. The new corners, in the middle of the sides that are cut, are launched
// at the source and traced to the present, so every corner is an exact ray. Two invocations a patch, one for each of them.
#include "lightsim/bake.glsl"
#include "lightsim/particle.glsl"
#include "lightsim/launch.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = BAKE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };

// Which corner of the first half is new; its old value becomes the same corner of the second half.
uint newCornerOfFirst(uint which, bool alongU) {
    return which == 1u ? 2u : (alongU ? 1u : 3u);
}

uint newCornerOfSecond(uint which, bool alongU) {
    return which == 0u ? 0u : (alongU ? 3u : 1u);
}

// Rectangle, power and counters of both halves. The launch rectangle of the parent is passed in: the other invocation
// may be reading it still, so `settle` runs after both have (a barrier lies between).
void settle(uint slot, uint secondSlot, vec2 launchMin, vec2 launchMax, bool alongU) {
    LaunchFrame frame = frames[patches[slot].frameIndex];
    vec2 middle = 0.5 * (launchMin + launchMax);
    vec2 firstMax = alongU ? vec2(middle.x, launchMax.y) : vec2(launchMax.x, middle.y);
    vec2 secondMin = alongU ? vec2(middle.x, launchMin.y) : vec2(launchMin.x, middle.y);
    patches[slot].launchMax = firstMax;
    patches[slot].power = launchPower(frame, launchMin, firstMax);
    patches[secondSlot].launchMin = secondMin;
    patches[secondSlot].launchMax = launchMax;
    patches[secondSlot].power = launchPower(frame, secondMin, launchMax);
    patches[secondSlot].frameIndex = patches[slot].frameIndex;
    patches[secondSlot].stepCount = patches[slot].stepCount;
    patches[secondSlot].orientation = patches[slot].orientation;
    appendLive(slot);
    appendLive(secondSlot);
}

void main() {
    uint index = gl_GlobalInvocationID.x / 2u;
    uint which = gl_GlobalInvocationID.x % 2u;
    bool listed = index < queue.splitCount;
    index = min(index, max(queue.splitCount, 1u) - 1u);
    uint entry = slotLists[SPLIT_LIST * settings.capacity + index];
    uint secondSlot = slotLists[SPLIT_TARGET_LIST * settings.capacity + index];
    uint slot = entry & ~SPLIT_ALONG_U;
    bool alongU = (entry & SPLIT_ALONG_U) != 0u;
    vec2 launchMin = patches[slot].launchMin;
    vec2 launchMax = patches[slot].launchMax;
    barrier();
    if (!listed) {
        return;
    }
    vec2 middle = 0.5 * (launchMin + launchMax);
    vec2 low = alongU ? vec2(middle.x, launchMin.y) : vec2(launchMin.x, middle.y);
    vec2 high = alongU ? vec2(middle.x, launchMax.y) : vec2(launchMax.x, middle.y);
    uint evaluations = 0u;
    Particle corner = tracedParticle(frames[patches[slot].frameIndex], which == 0u ? low : high, patches[slot].stepCount,
                                     evaluations);
    uint moved = newCornerOfFirst(which, alongU);
    patches[secondSlot].corners[moved] = patches[slot].corners[moved];
    patches[slot].corners[moved] = corner;
    patches[secondSlot].corners[newCornerOfSecond(which, alongU)] = corner;
    if (which == 0u) {
        settle(slot, secondSlot, launchMin, launchMax, alongU);
    }
    countEvaluations(evaluations);
}

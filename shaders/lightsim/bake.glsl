// The pool of patches and its queue.
#include "lightsim/settings.glsl"

layout(std430, binding = BAKE_PATCHES_BINDING) buffer PatchBlock {
    WavefrontPatch patches[];
};

layout(std430, binding = BAKE_QUEUE_BINDING) buffer QueueBlock {
    QueueState queue;
    uint slotLists[];
};

uint groupsFor(uint invocations) {
    return (invocations + BAKE_GROUP_SIZE - 1u) / BAKE_GROUP_SIZE;
}

uint liveSlot(uint i) {
    return slotLists[queue.parity * settings.capacity + i];
}

// The patch is alive in the next round.
void appendLive(uint slot) {
    uint i = atomicAdd(queue.nextLiveCount, 1u);
    slotLists[(1u - queue.parity) * settings.capacity + i] = slot;
}

void listForRetire(uint slot) {
    uint i = atomicAdd(queue.retireCount, 1u);
    slotLists[RETIRE_LIST * settings.capacity + i] = slot;
    atomicMax(queue.retireGroups.x, groupsFor(i + 1u));
}

// The patch keeps one half, the other goes to `secondSlot`.
void listForSplit(uint slot, uint secondSlot, bool alongU) {
    uint i = atomicAdd(queue.splitCount, 1u);
    slotLists[SPLIT_LIST * settings.capacity + i] = slot | (alongU ? SPLIT_ALONG_U : 0u);
    slotLists[SPLIT_TARGET_LIST * settings.capacity + i] = secondSlot;
    atomicMax(queue.splitGroups.x, groupsFor(2u * (i + 1u)));
}

// The deposit of the patch's last step is left to its corners.
void listForCorners(uint slot) {
    uint i = atomicAdd(queue.cornersCount, 1u);
    slotLists[CORNERS_LIST * settings.capacity + i] = slot;
    atomicMax(queue.cornersGroups.x, groupsFor(4u * (i + 1u)));
}

void returnSlot(uint slot) {
    uint place = atomicAdd(queue.freeTail, 1u) % settings.capacity;
    slotLists[FREE_RING * settings.capacity + place] = slot;
}

// A slot that was free before this round; false when there is none.
bool takeFreeSlot(out uint slot) {
    uint place = atomicAdd(queue.freeHead, 1u);
    slot = slotLists[FREE_RING * settings.capacity + place % settings.capacity];
    return place < queue.freeTailAtStart;
}

void countEvaluations(uint evaluations) {
    uint before = atomicAdd(queue.evaluationsLow, evaluations);
    if (before + evaluations < before) {
        atomicAdd(queue.evaluationsHigh, 1u);
    }
}

// Schedule: one invocation keeps the books of the pool between rounds, so that the CPU never waits for a count.
// SCHEDULE_EMIT: before emit, how many patches to begin. Otherwise: after it, the next list becomes the live one.
#include "lightsim/bake.glsl"

layout(local_size_x = 1) in;

const uint kSplitReserve = 4u;  // a quarter of the pool is kept for the halves of split patches

void planEmission() {
    queue.freeHead = min(queue.freeHead, queue.freeTailAtStart);
    uint free = queue.freeTail - queue.freeHead;
    queue.recordTake = min(queue.recordCount, free);
    uint reserve = settings.capacity / kSplitReserve;
    uint spare = free > queue.recordTake + reserve ? free - queue.recordTake - reserve : 0u;
    uint cells = min(spare, settings.cellCount - queue.nextCell);
    queue.emitCount = queue.recordTake + cells;
    queue.emitGroups = uvec3(groupsFor(4u * queue.emitCount), 1u, 1u);
}

void beginRound() {
    queue.freeHead += queue.emitCount;
    queue.nextCell += queue.emitCount - queue.recordTake;
    queue.recordCount -= queue.recordTake;
    queue.emitCount = 0u;
    queue.recordTake = 0u;
    queue.freeTailAtStart = queue.freeTail;
    queue.parity = 1u - queue.parity;
    queue.liveCount = queue.nextLiveCount;
    queue.nextLiveCount = 0u;
    queue.peakLive = max(queue.peakLive, queue.liveCount);
    uint before = queue.stepsLow;
    queue.stepsLow += queue.liveCount;
    queue.stepsHigh += queue.stepsLow < before ? 1u : 0u;
    queue.particleGroups = uvec3(groupsFor(4u * queue.liveCount), 1u, 1u);
    queue.patchGroups = uvec3(groupsFor(queue.liveCount), 1u, 1u);
    queue.cornersCount = 0u;
    queue.cornersGroups = uvec3(0u, 1u, 1u);
    queue.retireCount = 0u;
    queue.retireGroups = uvec3(0u, 1u, 1u);
    queue.splitCount = 0u;
    queue.splitGroups = uvec3(0u, 1u, 1u);
}

void main() {
#ifdef SCHEDULE_EMIT
    planEmission();
#else
    beginRound();
#endif
}

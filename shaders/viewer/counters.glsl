// Statistics of all rays: sums of two words each.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageCounters) buffer Counters { uint counters[8]; };

void addToCounter(int counter, uint value) {
    uint before = atomicAdd(counters[2 * counter], value);
    if (before + value < before) {
        atomicAdd(counters[2 * counter + 1], 1u);
    }
}

void addToCounters(RayCost cost) {
    addToCounter(0, cost.entered);
    addToCounter(1, cost.evaluations);
    addToCounter(2, cost.lookUps);
    addToCounter(3, cost.matterSamples);
}

RayCost costOfAll(RayCost a, RayCost b) {
    return RayCost(a.entered + b.entered, a.evaluations + b.evaluations, a.lookUps + b.lookUps, a.matterSamples + b.matterSamples);
}

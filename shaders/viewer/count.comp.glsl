// Adds what the rays of a tile have cost to the statistics.
#include "viewer/ray_states.glsl"

layout(local_size_x = kRaysPerGroup) in;

layout(std430, binding = kStorageCounters) buffer Counters { uint counters[8]; };

void addToCounter(int counter, uint value) {
    uint before = atomicAdd(counters[2 * counter], value);
    if (before + value < before) {
        atomicAdd(counters[2 * counter + 1], 1u);
    }
}

void main() {
    uint first = gl_GlobalInvocationID.x * uint(kRaysPerCount);
    if (first >= rayCount) {
        return;
    }
    uint entered = 0u, evaluations = 0u, lookUps = 0u, matterSamples = 0u;
    for (uint index = first; index < min(first + uint(kRaysPerCount), rayCount); ++index) {
        if (isFollowed(rays[index])) {
            entered += rays[index].status == kMissed ? 0u : 1u;
            evaluations += rays[index].evaluations;
            lookUps += rays[index].lookUps;
            matterSamples += rays[index].matterSamples;
        }
    }
    addToCounter(0, entered);
    addToCounter(1, evaluations);
    addToCounter(2, lookUps);
    addToCounter(3, matterSamples);
}

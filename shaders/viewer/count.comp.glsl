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
    if (first >= view.rayCount) {
        return;
    }
    uint entered = 0u, evaluations = 0u, lookUps = 0u, matterSamples = 0u;
    for (uint index = first; index < min(first + uint(kRaysPerCount), view.rayCount); ++index) {
        RayState ray = loadRay(index);
        if (isFollowed(ray)) {
            entered += ray.status == kMissed ? 0u : 1u;
            evaluations += ray.evaluations;
            lookUps += ray.lookUps;
            matterSamples += ray.matterSamples;
        }
    }
    addToCounter(0, entered);
    addToCounter(1, evaluations);
    addToCounter(2, lookUps);
    addToCounter(3, matterSamples);
}

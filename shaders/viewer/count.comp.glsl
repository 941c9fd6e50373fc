// Adds what the rays of a tile have cost to the statistics.
#include "viewer/ray_states.glsl"
#include "viewer/counters.glsl"

layout(local_size_x = kRaysPerGroup) in;

void main() {
    uint first = gl_GlobalInvocationID.x * uint(kRaysPerCount);
    if (first >= view.rayCount) {
        return;
    }
    RayCost sum = RayCost(0u, 0u, 0u, 0u);
    for (uint index = first; index < min(first + uint(kRaysPerCount), view.rayCount); ++index) {
        RayState ray = loadRay(index);
        if (isFollowed(ray)) {
            sum = costOfAll(sum, costOf(ray));
        }
    }
    addToCounters(sum);
}

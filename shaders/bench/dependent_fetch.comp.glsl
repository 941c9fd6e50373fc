// Nothing but trilinear fetches, each at a place that the one before decides: the rate that marching would have if all but
// its evaluations of the index were free. Along the rays' first directions, a step apart.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"

layout(local_size_x = kRaysPerGroup) in;

// Makes the next place depend on the value and moves it by less than a float tells.
const float kNearlyNothing = 1e-12;

void main() {
    uint index = gl_GlobalInvocationID.x;
    RayState ray = loadRay(min(index, view.rayCount - 1u));
    if (index >= view.rayCount || ray.status != kMarching) {
        return;
    }
    vec3 x = (ray.x - domain.min) * domain.scale;
    vec3 step = unitDirection(ray) * view.stepLength * domain.scale;
    vec4 texel = vec4(0.0);
    for (uint i = 0u; i < view.stepsPerSlice; ++i) {
        x += step + kNearlyNothing * texel.rgb;
        texel = sampleTrilinear(opticsGrid, x);
    }
    ray.radiance = texel.rgb;
    storeRows(index, rowsOf(ray), kSeenRow, kCrossingRow);
}

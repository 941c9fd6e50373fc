// Nothing but trilinear fetches, each at a place that the one before decides: the rate that marching would have if all but
// its evaluations of the index were free. Along the first directions of the rays that are listed, a step apart, to and fro in the
// domain: beyond it all fetches would be of its face.
#include "viewer/ray_states.glsl"
#include "viewer/ray_lists.glsl"
#include "fields/fields.glsl"

layout(local_size_x = kRaysPerGroup) in;

// Makes the next place depend on the value and moves it by less than a float tells.
const float kNearlyNothing = 1e-12;

void main() {
    uint entry = listedEntry();
    if (entry == kNoEntry) {
        return;
    }
    uint index = entry & ~kIsPlain;
    RayState ray = loadRay(index);
    vec3 x = (ray.x - domain.min) * domain.scale;
    vec3 step = unitDirection(ray) * view.stepLength * domain.scale;
    vec4 texel = vec4(0.0);
    for (uint i = 0u; i < view.stepsPerSlice; ++i) {
        step = any(greaterThan(abs(x - 0.5), vec3(0.5))) ? -step : step;
        x += step + kNearlyNothing * texel.rgb;
        texel = sampleTrilinear(opticsGrid, x);
    }
    ray.radiance = texel.rgb;
    storeRows(index, rowsOf(ray), kSeenRow, kCrossingRow);
}

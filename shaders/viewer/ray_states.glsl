// The rays of a tile, one a pixel or one a row of the input.
#include "gpu/division.glsl"
#include "shared/view_blocks.h"
#include "viewer/ray_rows.glsl"

// Rays are read as texels and written row by row: the software renderer takes a tenth of the time that it takes to read storage,
// and a third of that to write it word by word.
layout(std430, binding = kStorageRays) writeonly buffer Rays { uvec4 rayRows[]; };
layout(binding = kUnitRays) uniform usamplerBuffer rayTexels;

// The ray that this invocation follows.
uint rayIndex;

RayState loadRay(uint index) {
    RayRows rows;
    for (int i = 0; i < kRowsPerRay; ++i) {
        rows.row[i] = texelFetch(rayTexels, kRowsPerRay * int(index) + i);
    }
    return rayOf(rows);
}

// Some rows of a ray, from `first` up to `end`.
void storeRows(uint index, RayRows rows, int first, int end) {
    for (int i = first; i < end; ++i) {
        rayRows[kRowsPerRay * int(index) + i] = rows.row[i];
    }
}

void storeWholeRay(uint index, RayState ray) {
    storeRows(index, rowsOf(ray), 0, kRowsPerRay);
}

// Pixel of a ray within the tile, row after row.
ivec2 tilePixel(uint index) {
    return ivec2(divided(index, uint(view.tileSize.x)).yx);
}

// A sample's rays are followed at the reference wavelength, then, where something disperses, once for every band.
bool isReferencePass() {
#ifdef EFFECT_DISPERSION
    return view.bandChannel == kAllChannels;
#else
    return true;
#endif
}

// Rays that have met no dispersion go the same way in every band: the reference pass is all that they need.
bool isFollowed(RayState ray) {
    return isReferencePass() || ray.dispersed != 0u;
}

// A ray in the domain that has met nothing yet, as if it began in vacuum. `w`: its wave vector.
RayState newRay(vec3 x, vec3 w) {
    RayState ray;
    ray.x = x;
    ray.pathLength = 0.0;
    ray.w = w;
    ray.opticalLength = 0.0;
    ray.depth = vec3(0.0);
    ray.evaluations = 0u;
    ray.transmittance = vec3(1.0);
    ray.status = kMarching;
    ray.radiance = vec3(0.0);
    ray.throughputS = 1.0;
    ray.crossingNormal = vec3(0.0);
    ray.throughputP = 1.0;
    ray.crossingGradMax = 0.0;
    ray.crossingStart = 1.0;
    ray.crossingWeight = 0.0;
    ray.crossingAlong = 0.0;
    ray.n = 1.0;
    ray.nCamera = 1.0;
    ray.entryDistance = 0.0;
    ray.lookUps = 0u;
    ray.lookAgainAt = 0.0;
    ray.matterSamples = 0u;
    ray.dispersed = view.dispersedAtStart;
    ray.generation = 0u;
    return ray;
}

vec3 unitDirection(RayState ray) {
    return ray.w / length(ray.w);
}

// What is left, on the average of both polarisations, of light that comes from behind.
vec3 rayThroughput(RayState ray) {
    return ray.transmittance * (0.5 * (ray.throughputS + ray.throughputP));
}

RayCost costOf(RayState ray) {
    return RayCost(ray.status == kMissed ? 0u : 1u, ray.evaluations, ray.lookUps, ray.matterSamples);
}

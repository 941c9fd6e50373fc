// The rays of a tile, one a pixel or one a row of the input.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageRays) buffer Rays { RayState rays[]; };

// The ray that this invocation follows.
uint rayIndex;

// Pixel of a ray within the tile, row after row.
ivec2 tilePixel(uint index) {
    return ivec2(int(index) % tileSize.x, int(index) / tileSize.x);
}

// A sample's rays are followed at the reference wavelength, then, where something disperses, once for every band.
bool isReferencePass() {
#ifdef EFFECT_DISPERSION
    return bandChannel == kAllChannels;
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
    ray.crossingWTangential = 0.0;
    ray.crossingSide = 0.0;
    ray.n = 1.0;
    ray.nCamera = 1.0;
    ray.entryDistance = 0.0;
    ray.lookUps = 0u;
    ray.lookAgainAt = 0.0;
    ray.matterSamples = 0u;
    ray.dispersed = dispersedAtStart;
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

// The rays of a tile, one a pixel or one a row of the input.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageRays) buffer Rays { RayState rays[]; };

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

vec3 unitDirection(RayState ray) {
    return ray.w / length(ray.w);
}

// What is left, on the average of both polarisations, of light that comes from behind.
vec3 rayThroughput(RayState ray) {
    return ray.transmittance * (0.5 * (ray.throughputS + ray.throughputP));
}

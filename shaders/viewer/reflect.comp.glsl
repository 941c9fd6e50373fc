// A round of reflections: what the ray of the last round saw goes to its pixel's ray, and the last of the reflections that wait
// there becomes a ray. Marching and shading do the rest, as for rays from the camera.
#include "viewer/ray_states.glsl"
#include "viewer/ray_lists.glsl"
#include "fields/fields.glsl"
#include "viewer/ray_crossing.glsl"
#include "shared/reflection_blocks.h"

layout(local_size_x = kRaysPerGroup) in;

layout(std430, binding = kStorageReflections) buffer Reflections { PixelReflections reflections[]; };
layout(std430, binding = kStorageDirectRays) buffer DirectRays { RayState directRays[]; };

// Adds an ended reflection to the pixel's ray; both hold basic radiance.
void gather(uint index, RayState ended) {
    directRays[index].radiance += ended.radiance;
    directRays[index].evaluations += ended.evaluations;
    directRays[index].lookUps += ended.lookUps;
    directRays[index].matterSamples += ended.matterSamples;
    directRays[index].dispersed |= ended.dispersed;
}

// A ray that comes back from its mirror. Its radiance stays basic until the pixel's ray is shaded: nCamera is 1.
RayState rayFrom(Reflection from, uint dispersed) {
    Optics optics = sampleOptics(from.x);
    RayState ray = newRay(from.x, from.w);
    ray.evaluations = 1u;
    ray.transmittance = from.transmittance;
    ray.throughputS = from.throughputS;
    ray.throughputP = from.throughputP;
    setCrossing(ray, crossingFromMirror(from.w, optics.n, optics.gradN));
    ray.n = optics.n;
    ray.dispersed = dispersed;
    ray.generation = uint(unpackHalf2x16(from.generationAndSpread).x);
    return ray;
}

// What is to be listed of the ray.
uint nextRound(uint index) {
    RayState ended = loadRay(index);
    if (ended.status != kNoRay) {
        gather(index, ended);
    }
    uint waiting = reflections[index].waiting;
    if (waiting == 0u) {
        ended.status = kNoRay;
        storeWholeRay(index, ended);
        reflections[index].facets = 0u;
        reflections[index].spread = 0.0;
        return kNoEntry;
    }
    Reflection from = reflections[index].list[waiting - 1u];
    storeWholeRay(index, rayFrom(from, directRays[index].dispersed));
    reflections[index].waiting = waiting - 1u;
    reflections[index].spread = unpackHalf2x16(from.generationAndSpread).y;
    reflections[index].startX = from.x;
    reflections[index].startW = from.w;
    reflections[index].startTransmittance = from.transmittance;
    return index | kIsPlain;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    listRay(index < view.rayCount ? nextRound(index) : kNoEntry);
}

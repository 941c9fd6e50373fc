#pragma once
// Reflections that wait to be followed by viewing rays.

#include "shaders/shared/bindings.h"

#ifdef __cplusplus
#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::gpu {

using glm::vec3;
using uint = unsigned int;
#endif

const int kStorageReflections = 6;  // PixelReflections, one a ray from the camera
const int kStorageDirectRays = 7;   // RayState of the rays from the camera, while those of reflections are kStorageRays

// One more than these is seen in the environment.
const int kMostWaiting = 8;

// A ray that leaves a mirror.
struct Reflection {
    vec3 x;              // before the boundary [scene units]
    float throughputS;   // as RayState's, times the mirror's reflectances
    vec3 w;              // wave vector away from it
    float throughputP;
    vec3 transmittance;  // as RayState's when it sets out
    uint generationAndSpread;  // packHalf2x16: RayState::generation, PixelReflections::spread
};

struct PixelReflections {
    vec3 steepestX;   // of the boundary that the ray under way is crossing: where |grad n| was largest so far
    uint waiting;     // of `list`, the first so many
    vec3 steepestW;   // wave vector there
    uint facets;      // of rough boundaries that the sample has met
    vec3 steepestTransmittance;
    float spread;     // of the ray under way: solid angle of the directions that it stands for, behind rough boundaries [sr]
    vec3 startX;      // where that boundary began
    float padB;
    vec3 startW;
    float padC;
    vec3 startTransmittance;
    float padD;
    Reflection list[kMostWaiting];
};

#ifdef __cplusplus
static_assert(sizeof(Reflection) == 48 && offsetof(Reflection, w) == 16 && offsetof(Reflection, generationAndSpread) == 44);
static_assert(offsetof(PixelReflections, waiting) == 12 && offsetof(PixelReflections, list) == 96);
static_assert(sizeof(PixelReflections) == 96 + 48 * kMostWaiting);

} // namespace eikonal::gpu
#endif

#pragma once
// What each effect of a scene adds to the cost of its image.

#include <functional>
#include <string>
#include <vector>

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/gpu/context.h"
#include "viewer/render.h"

namespace eikonal::bench {

/// The image with this effect and all those of the rungs before it.
struct Rung {
    std::string added;
    double seconds = 0.0;    ///< of the image, without set-up; the shortest of the repeats
    std::uint64_t fetches = 0;  ///< of textures, but for the few at the ends of rays
    RenderStatistics statistics;
};

/// Refraction first, then the other effects that are on, one by one; the last rung has all. `light` serves those that show
/// it; `progress` gets the share done.
std::vector<Rung> climbLadder(const gpu::Context& context, const Scene& scene, const Fields& fields,
                              const EffectSet& effects, const BakedLight* light, int repeats,
                              const std::function<void(double)>& progress);

/// One row a rung, with a header. `march_instructions`, of the marching kernels, is empty where the driver does not tell.
std::string ladderCsv(const std::vector<Rung>& rungs);

} // namespace eikonal::bench

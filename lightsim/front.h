#pragma once
// Wavefronts as they are at given times: the patches of the light simulator, for pictures and measurements
// (Fig. 6.1 of the 2007 thesis).

#include <array>
#include <cstdint>
#include <vector>

#include "lightsim/bake.h"

namespace eikonal {

/// A piece of a wavefront.
struct FrontPatch {
    double opticalTime = 0.0;           ///< optical path since its light's front first met the domain [scene units]
    std::array<glm::vec3, 4> corners;   ///< in order around the patch [scene units]
    glm::vec3 irradiance{0.0f};         ///< power over the area covered across the direction of travel, by band
    bool folded = false;                ///< turned inside out an odd number of times
    std::uint32_t launchFrame = 0;      ///< launch surface that it comes from, and its rectangle there
    glm::vec2 launchMin{0.0f}, launchMax{0.0f};
};

/// The fronts of all lights, as they stand at frame 0, at each of the times, in that order, at the reference wavelength;
/// patches by their place on the launch surfaces. Only patches that reach into the domain, in which light still travels, and
/// that are a surface: not those too weak to be split that have grown longer than the others may be. None where no light is
/// left. Patches follow the scene's accuracy. Times must be positive. Of the options, maxBlockBytes is not used. Throws
/// Error(kFailure) when interrupted.
std::vector<FrontPatch> frontsAt(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                 const EffectSet& effects, const std::vector<double>& opticalTimes,
                                 const BakeOptions& options);

} // namespace eikonal

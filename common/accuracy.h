#pragma once
// What "auto" means where a scene leaves its accuracy to the program.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/scene.h"

namespace eikonal {

/// Step of viewing rays [voxels]. Steps of exactly one voxel beat with the kinks that trilinear interpolation has at every
/// voxel: through a smoothed sphere at 128³ they err by 9e-4 in direction, 0.75 by 3e-4, and smaller ones gain nothing
/// (docs/performance.md).
constexpr double kAutoStepVoxels = 0.75;

inline double stepVoxelsOf(const Accuracy& accuracy) { return accuracy.stepVoxels.value_or(kAutoStepVoxels); }

/// As scenes name them.
inline constexpr std::array<std::pair<std::string_view, Integrator>, 5> kIntegrators{{{"auto", Integrator::kAuto},
                                                                                     {"euler", Integrator::kEuler},
                                                                                     {"leapfrog", Integrator::kLeapfrog},
                                                                                     {"rk4", Integrator::kRk4},
                                                                                     {"sharma", Integrator::kSharma}}};
inline constexpr std::array<std::pair<std::string_view, Interpolation>, 3> kInterpolations{
    {{"auto", Interpolation::kAuto}, {"linear", Interpolation::kLinear}, {"cubic", Interpolation::kCubic}}};
std::string_view interpolationName(Interpolation interpolation);
/// Of the index along viewing rays: linear, or cubic below a tolerance that linear interpolation on voxels does not reach
/// (docs/accuracy.md).
Interpolation interpolationOfImages(const Accuracy& accuracy);
/// Of viewing rays: leapfrog unless another is asked for.
Integrator integratorOf(const Accuracy& accuracy);

/// Throws badInput for methods that exclude each other.
void requireAvailable(const Scene& scene);
/// For the user where light is simulated and the scene asks for an integrator that light does not go by.
std::optional<std::string> warningOfIntegrator(const Scene& scene);

} // namespace eikonal

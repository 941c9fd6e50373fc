#pragma once
// The same scene for light that is there at once.

#include "common/scene.h"

namespace eikonal::window {

inline constexpr int kCoarseResolution = 24;  ///< voxels along the longest side
inline constexpr double kCoarseTolerance = 0.25;

/// At most that resolution, at least that tolerance.
Scene coarse(Scene scene);
bool isCoarse(const Scene& scene);

} // namespace eikonal::window

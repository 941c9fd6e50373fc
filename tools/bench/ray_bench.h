#pragma once
// Integrators of the ray equation against closed forms: error of the ray's end over field evaluations.

#include <vector>

#include "tools/bench/work_precision.h"

namespace eikonal::bench {

struct RayBenchOptions {
    int rays = 64;                              ///< in each case
    std::vector<int> resolutions{32, 64, 128, 256};  ///< voxels along the box's edge, ascending
    int drawnResolution = 128;
    double longestStepVoxels = 16.0;            ///< of 128 along the edge, on every field; then halves of it
    int steps = 9;                              ///< settings of each curve
};

Family benchRays(const RayBenchOptions& options);

} // namespace eikonal::bench

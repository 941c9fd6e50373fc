#pragma once
// Images against a reference in double precision: step of viewing rays, samples of a pixel, tolerance of the bake.

#include <vector>

#include "common/gpu/context.h"
#include "tools/bench/work_precision.h"

namespace eikonal::bench {

struct ImageBenchOptions {
    int pixels = 64;                                     ///< along each edge of the image
    int resolution = 48;                                 ///< voxels along the box's edge
    std::vector<double> stepsVoxels{4.0, 2.0, 1.0, 0.75, 0.5, 0.25, 0.125};
    std::vector<int> samples{1, 2, 4, 8, 16, 32};
    std::vector<double> tolerances{0.16, 0.08, 0.04, 0.02, 0.01};
};

/// A glass sphere in smoke under a sky. Error: RMS over the pixels, relative to the mean radiance.
Family benchImage(const gpu::Context& context, const ImageBenchOptions& options);

} // namespace eikonal::bench

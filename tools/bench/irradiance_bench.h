#pragma once
// Methods of a bake against closed forms: error of irradiance over field evaluations and seconds.

#include <vector>

#include "common/gpu/context.h"
#include "tools/bench/work_precision.h"

namespace eikonal::bench {

struct IrradianceBenchOptions {
    std::vector<int> resolutions{32, 64};  ///< voxels along the longest side, ascending; the last one is drawn
    std::vector<double> tolerances{0.8, 0.4, 0.16, 0.08, 0.04, 0.02, 0.01};
};

Family benchIrradiance(const gpu::Context& context, const IrradianceBenchOptions& options);

} // namespace eikonal::bench

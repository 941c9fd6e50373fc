#pragma once
// What the irradiance of a bake is off by, estimated from a second look at the same light: other rays, with steps and launch
// cells a quarter longer, through a cubic spline of the index where the bake has linear interpolation.

#include <functional>

#include "lightsim/bake.h"

namespace eikonal {

/// Σ|E − E*|/ΣE* over voxels and bands.
struct BakeErrorEstimate {
    double total = 0.0;        ///< root of the sum of squares of the parts below, which have nothing to do with each other
    double propagation = 0.0;  ///< of rays and what is interpolated between them and between voxels: by the second look
    double averaging = 0.0;    ///< of what stands for a voxel's mean, samples or a hat: by the curvature of the grid
    std::uint64_t fieldEvaluations = 0;  ///< of the second look
    double seconds = 0.0;                ///< that it took
};

/// Whether the error of such bakes can be estimated: those of the method of 2007 have no limit that they are off from.
bool hasErrorEstimate(const Accuracy& accuracy);

/// Estimates for any number of bakes by LightSimulators of the same scene. A second look takes about as long as the bake.
class BakeErrorEstimator {
public:
    /// Keeps references to the context and the fields. The accuracy must have an estimate.
    BakeErrorEstimator(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                       BakeOptions options);

    /// Over the voxels that `isCompared`, by number, or all. Throws as LightSimulator::bake.
    BakeErrorEstimate estimate(const LightSet& lights, const BakedLight& bake,
                               const std::function<bool(std::size_t voxel)>& isCompared = {});

private:
    double averagingWeight_;
    const Fields& fields_;
    LightSimulator secondLook_;
};

} // namespace eikonal

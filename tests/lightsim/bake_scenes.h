#pragma once
// Scenes for the light simulator, made in memory.

#include <functional>

#include "lightsim/bake.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal::test {

Scene sceneWith(const Light& light);

/// Bakes with the shared context, effects as the scene calls for them.
BakeResult bake(const Scene& scene, const Fields& fields, const BakeOptions& options = {});

/// A glass sphere of radius 0.6 and index 1.5 that absorbs by band, in scattering smoke; the boundary reflects.
Fields absorbingSphereInSmoke(int resolution);

/// A smoothed glass sphere of radius 0.6 and index 1.5 without Fresnel terms: refraction and deposit alone.
Fields clearSphere(int resolution);

/// Σ|a - b| / Σ b over the first band.
double relativeL1(const DenseGrid<glm::vec3>& a, const DenseGrid<glm::dvec3>& b);

/// Of irradiance in the first band, relative to a truth.
struct RelativeErrors {
    double rms = 0.0, bias = 0.0;
    double median = 0.0;  ///< of absolute values
    int voxels = 0;
};

/// Errors over the voxels whose centre `isCompared`, both functions of a world position. A voxel should hold the mean of
/// `truth` over its cube: eight Gauss points.
RelativeErrors errorsAgainst(const BakedLight& light, const std::function<bool(const glm::dvec3&)>& isCompared,
                             const std::function<double(const glm::dvec3&)>& truth);

} // namespace eikonal::test

#include "lightsim/error_estimate.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <numbers>

#include "lightsim/settings.h"

namespace eikonal {

namespace {

using Grid = DenseGrid<glm::vec3>;

// Far enough from 1 for rays, cells and patches to lie elsewhere in all of the domain, near enough for the second look to err
// by as much as the first.
constexpr double kSecondMesh = 1.25;

/// Variance along each axis by which what stands for a voxel's mean is wider or narrower than its cube, over two [voxels²]: of a
/// hat h²/6 against h²/12; of n samples an edge h²/12 (1 − 1/n²).
double averagingWeightOf(const Accuracy& accuracy, const Fields& fields) {
    const double hat = 1.0 / 24.0;
    const double samples = bake::usesPatches(accuracy) ? 1.0 : bake::tubeSettingsOf(accuracy, fields).samplesPerVoxel;
    return hat / (samples * samples);
}

/// One direction in each voxel and no eikonal: irradiance is all that is compared. The index is interpolated in the other way.
Scene secondLookOf(Scene scene, const Fields& fields) {
    const bool isLinear = bake::interpolationOfLight(scene.accuracy, fields.ior) == Interpolation::kLinear;
    scene.accuracy.interpolation = isLinear ? Interpolation::kCubic : Interpolation::kLinear;
    scene.accuracy.directional = Directional::kMean;
    return scene;
}

BakeOptions ofSecondLook(BakeOptions options) {
    options.meshScale *= kSecondMesh;
    options.eikonal = false;
    options.progress = {};
    return options;
}

/// Second differences along all axes, h² times the Laplacian. At the faces and beside opaque matter an axis is left out.
glm::vec3 secondDifferences(const Grid& grid, const DenseGrid<float>& opaque, const glm::ivec3& voxel) {
    glm::vec3 sum(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        if (voxel[axis] == 0 || voxel[axis] == grid.size[axis] - 1) continue;
        glm::ivec3 before = voxel, after = voxel;
        --before[axis];
        ++after[axis];
        const bool isFree = opaque.empty() || std::max({opaque.at(before), opaque.at(voxel), opaque.at(after)}) <= 0.0f;
        if (isFree) sum += grid.at(before) - 2.0f * grid.at(voxel) + grid.at(after);
    }
    return sum;
}

double sumOf(const glm::vec3& bands) { return double(bands.x) + double(bands.y) + double(bands.z); }

} // namespace

bool hasErrorEstimate(const Accuracy& accuracy) { return accuracy.deposit != Deposit::kPeak; }

BakeErrorEstimator::BakeErrorEstimator(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                       const EffectSet& effects, BakeOptions options)
    : averagingWeight_(averagingWeightOf(scene.accuracy, fields)), fields_(fields),
      secondLook_(context, secondLookOf(scene, fields), fields, effects, ofSecondLook(options)) {
    assert(hasErrorEstimate(scene.accuracy));
}

BakeErrorEstimate BakeErrorEstimator::estimate(const LightSet& lights, const BakedLight& bake,
                                               const std::function<bool(std::size_t)>& isCompared) {
    const auto start = std::chrono::steady_clock::now();
    const BakeResult second = secondLook_.bake(lights);
    const glm::ivec3 size = bake.lattice.size;
    double apart = 0.0, curvature = 0.0, sum = 0.0;
    std::size_t number = 0;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i, ++number) {
                if (isCompared && !isCompared(number)) continue;
                const glm::vec3 own = bake.irradiance.values[number];
                apart += sumOf(glm::abs(own - second.light.irradiance.values[number]));
                curvature += sumOf(glm::abs(secondDifferences(bake.irradiance, fields_.opaque, {i, j, k})));
                sum += sumOf(own);
            }
        }
    }
    BakeErrorEstimate estimate;
    if (sum > 0.0) {
        estimate.propagation = apart / std::numbers::sqrt2 / sum;  // two errors, of either look
        estimate.averaging = averagingWeight_ * curvature / sum;
    }
    estimate.total = std::hypot(estimate.propagation, estimate.averaging);
    estimate.fieldEvaluations = second.statistics.patches.fieldEvaluations;
    estimate.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return estimate;
}

} // namespace eikonal

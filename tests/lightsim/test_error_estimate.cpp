// The error that a bake says it has, against the one that it has: very many rays in double precision through the closed form of
// the index. An estimate is right that is off by no more than a factor of three; nine in ten must be.
#include <gtest/gtest.h>

#include "common/reference/bake_reference.h"
#include "lightsim/error_estimate.h"
#include "tests/lightsim/bake_scenes.h"
#include "tests/support/lumps.h"

namespace eikonal {
namespace {

// A whole number of steps a voxel, for steps count in the voxel of their middle: others would err by a step where rays are
// straight. The truth errs by less than a tenth of what is judged.
constexpr reference::BeamBakeOptions kTruth{.raysPerVoxelEdge = 8, .stepVoxels = 0.125};

const DirectionalLight kBeam{{1.0, 0.0, 0.0}, glm::dvec3(1.0), {}};

Scene sceneWith(Deposit deposit, double tolerance) {
    Scene scene = test::sceneWith(kBeam);
    scene.accuracy.deposit = deposit;
    scene.accuracy.tolerance = tolerance;
    return scene;
}

BakeErrorEstimate estimateOf(const Scene& scene, const Fields& fields, const BakedLight& bake) {
    const EffectSet effects = decideEffects(scene, fields);
    BakeErrorEstimator estimator(test::sharedContext(), scene, fields, effects, {});
    return estimator.estimate(lightsAt(lightsOf(scene, effects), 0.0), bake);
}

TEST(BakeErrorEstimate, IsRightOnFiftyRandomFields) {
    constexpr double kTolerances[] = {0.4, 0.1, 0.05, 0.02, 0.01};
    int right = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const test::Lumps lumps(seed);
        const Lattice lattice = test::cube(seed % 3 == 0 ? 16 : 20, 1.0);
        const Fields fields = test::indexFields(lattice, [&](const glm::dvec3& x) { return lumps.optics(x).n; });
        const Scene scene = sceneWith(seed % 2 == 0 ? Deposit::kAuto : Deposit::kSplat, kTolerances[seed % 5]);
        const BakeResult bake = test::bake(scene, fields);
        const reference::ClosedForm closed([&](const glm::dvec3& x) { return lumps.optics(x); });
        const double error = test::relativeL1(bake.light.irradiance, reference::bakeBeam(closed, lattice, kTruth));
        const double ratio = estimateOf(scene, fields, bake.light).total / error;
        right += ratio > 1.0 / 3.0 && ratio < 3.0 ? 1 : 0;
        RecordProperty("error" + std::to_string(seed), std::to_string(error));
        RecordProperty("ratio" + std::to_string(seed), std::to_string(ratio));
    }
    EXPECT_GE(right, 45);
}

TEST(BakeErrorEstimate, IsThatOfTheVoxelsAskedFor) {
    const Fields fields = test::clearSphere(16);
    const Scene scene = sceneWith(Deposit::kAuto, 0.05);
    const BakeResult bake = test::bake(scene, fields);
    const EffectSet effects = decideEffects(scene, fields);
    const LightSet lights = lightsAt(lightsOf(scene, effects), 0.0);
    BakeErrorEstimator estimator(test::sharedContext(), scene, fields, effects, {});
    const BakeErrorEstimate everywhere = estimator.estimate(lights, bake.light);
    // before the sphere the beam is as it was launched: all of the error is behind its front
    const auto isBefore = [&](std::size_t voxel) { return voxel % 16 < 2; };
    const BakeErrorEstimate before = estimator.estimate(lights, bake.light, isBefore);
    const reference::SmoothedSphere sphere(0.6, 1.5, 1.5 * fields.lattice.voxel);
    const double error = test::relativeL1(bake.light.irradiance, reference::bakeSymmetricBeam(sphere, fields.lattice, {}));
    EXPECT_GT(everywhere.total, error / 3.0);
    EXPECT_LT(before.total, 0.1 * everywhere.total);
    EXPECT_EQ(estimator.estimate(lights, bake.light).total, everywhere.total);  // a second look leaves nothing behind
}

TEST(BakeErrorEstimate, IsNothingInDarknessAndOfTheMethodOf2007) {
    Scene scene = sceneWith(Deposit::kAuto, 0.05);
    std::get<DirectionalLight>(scene.lights.front()).irradiance = glm::dvec3(0.0);
    const Fields fields = test::clearSphere(8);
    EXPECT_EQ(estimateOf(scene, fields, test::bake(scene, fields).light).total, 0.0);
    EXPECT_FALSE(hasErrorEstimate(sceneWith(Deposit::kPeak, 0.05).accuracy));
}

} // namespace
} // namespace eikonal

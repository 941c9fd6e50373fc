// The same scene gives the same bits, whatever the deposit: on repeat, with a pool too small for the wavefront, in slabs.
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Scene lamps(Deposit deposit) {
    Scene scene = test::sceneWith(DirectionalLight{{0.9, 0.3, 0.1}, glm::dvec3(1.0, 0.9, 0.7)});
    scene.lights.push_back(PointLight{{0.2, 0.7, 0.8}, glm::dvec3(3.0)});
    scene.accuracy.deposit = deposit;
    return scene;
}

void expectEqual(const BakeResult& a, const BakeResult& b) {
    EXPECT_EQ(a.light.irradiance.values, b.light.irradiance.values);
    EXPECT_EQ(a.light.lightDirection.values, b.light.lightDirection.values);
    for (int band = 0; band < 3; ++band) {
        // rays that two batches of tubes share enter the ledger in two parts, each rounded to single precision
        EXPECT_NEAR(a.statistics.energy.absorbed[band], b.statistics.energy.absorbed[band],
                    1e-6 * b.statistics.energy.absorbed[band]);
    }
    EXPECT_EQ(a.statistics.patches.folds, b.statistics.patches.folds);
}

class Repeat : public ::testing::TestWithParam<Deposit> {
protected:
    static BakeResult bakeWith(const BakeOptions& options) {
        static const Fields fields = test::absorbingSphereInSmoke(24);
        return test::bake(lamps(GetParam()), fields, options);
    }
};

TEST_P(Repeat, GivesTheSameBits) { expectEqual(bakeWith({}), bakeWith({})); }

TEST_P(Repeat, IsIndependentOfThePool) {
    const BakeResult small = bakeWith({.poolPatches = 512, .tubeVertices = 2048});
    EXPECT_LE(small.statistics.patches.peak, 2048u);
    EXPECT_EQ(small.statistics.patches.refusedSplits, 0u);
    expectEqual(small, bakeWith({}));
}

TEST_P(Repeat, IsIndependentOfTheLargestBlock) {
    // 24 x 24 voxels x 8 bytes a layer: seven layers a slab, four slabs, the last one thinner
    expectEqual(bakeWith({.maxBlockBytes = 7 * 24 * 24 * 8}), bakeWith({}));
}

INSTANTIATE_TEST_SUITE_P(OfEachDeposit, Repeat, ::testing::Values(Deposit::kSplat, Deposit::kPeak, Deposit::kAuto),
                         [](const auto& method) {
                             return method.param == Deposit::kPeak    ? "Peak"
                                    : method.param == Deposit::kSplat ? "Splat"
                                                                      : "Tubes";
                         });

TEST(RepeatOfTubes, IsIndependentOfHowWorkIsDivided) {
    Fields fields = test::absorbingSphereInSmoke(24);
    fields.opaque = DenseGrid<float>(fields.lattice.size, 0.0f);
    test::forEachVoxel(fields.lattice, [&](const glm::ivec3& v) {
        fields.opaque.at(v) = float(test::sphereCoverage(fields.lattice, v, 0.3));
    });
    fields.albedo = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.5f));
    const Scene scene = lamps(Deposit::kAuto);
    const EffectSet effects = decideEffects(scene, fields);
    const BakeResult usual = bakeScene(test::sharedContext(), scene, fields, effects, {});
    {
        const gpu::Context hardware = gpu::Context::windowless({.asHardware = true});
        expectEqual(bakeScene(hardware, scene, fields, effects, {}), usual);
    }
    test::sharedContext().makeCurrent();
}

} // namespace
} // namespace eikonal

// Rays that one kernel draws at once against the same rays kernel after kernel.
#include <cmath>

#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

Scene ballScene() {
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 28.0, 50);
    scene.render.size = {70, 50};  // of blocks that reach beyond it
    scene.render.samples = 3;
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    return scene;
}

RenderResult rendered(const Scene& scene, RenderOptions options, bool fused) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.6, 1.5, 0.1);
    options.fused = fused;
    return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr, options);
}

/// The same arithmetic, which compilers may contract in other ways: rays that graze the ball amplify that, so a few pixels may
/// differ by more than rounding.
void expectTheSame(const Scene& scene, const RenderOptions& options = {}) {
    const RenderResult fused = rendered(scene, options, true), staged = rendered(scene, options, false);
    ASSERT_EQ(fused.channels.size(), staged.channels.size());
    for (std::size_t c = 0; c < fused.channels.size(); ++c) {
        std::size_t others = 0;
        for (std::size_t i = 0; i < fused.channels[c].values.size(); ++i) {
            const float a = fused.channels[c].values[i], b = staged.channels[c].values[i];
            others += a == b || std::abs(a - b) <= 1e-4f * (1.0f + std::abs(b)) ? 0 : 1;  // infinite where rays miss
        }
        EXPECT_LE(others, fused.channels[c].values.size() / 100) << fused.channels[c].name;
    }
    const auto expectNear = [](std::uint64_t a, std::uint64_t b) { EXPECT_NEAR(double(a), double(b), 1e-3 * double(b)); };
    expectNear(fused.statistics.fieldEvaluations, staged.statistics.fieldEvaluations);
    expectNear(fused.statistics.clearanceLookUps, staged.statistics.clearanceLookUps);
    expectNear(fused.statistics.steps, staged.statistics.steps);
    EXPECT_EQ(fused.statistics.rays, staged.statistics.rays);
    EXPECT_NEAR(fused.statistics.noise, staged.statistics.noise, 1e-3 * staged.statistics.noise);
}

TEST(Fused, DrawsWhatKernelsDoOneAfterTheOther) { expectTheSame(ballScene()); }

TEST(Fused, StepsThroughEverything) { expectTheSame(ballScene(), {.straightFlights = false}); }

TEST(Fused, GoesOnFromSliceToSlice) {
    expectTheSame(ballScene(), {.stepsPerSlice = 7});
    expectTheSame(ballScene(), {.straightFlights = false, .stepsPerSlice = 7});
}

TEST(Fused, GoesOnFromTileToTile) { expectTheSame(ballScene(), {.tileRays = 700}); }

TEST(Fused, EndsRaysAtTheirLimit) { expectTheSame(ballScene(), {.straightFlights = false, .maxEvaluations = 20}); }

TEST(Fused, TakesALens) {
    Scene scene = ballScene();
    scene.camera.aperture = 0.3;
    scene.camera.focus = 3.0;
    expectTheSame(scene);
}

} // namespace
} // namespace eikonal

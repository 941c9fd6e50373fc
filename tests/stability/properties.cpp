#include "tests/stability/properties.h"

#include <cmath>

#include "common/scene_toml.h"
#include "tests/stability/hard_cases.h"
#include "tests/stability/random_scene.h"
#include "viewer/trace.h"

namespace eikonal::test {

namespace {

/// The field of a random index on voxels, and rays across it.
struct RandomField {
    Fields fields;
    std::vector<TraceRay> rays;
};

RandomField randomField(std::uint64_t seed) {
    const std::string text = fieldInSmoke(randomIndex(seed));
    RandomField random{composeFields(parseScene(text, "random.toml", ".", {"domain.resolution=32"})), {}};
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.399963229728653 * i, r = 0.9 * std::sqrt((i + 0.5) / 40.0);
        random.rays.push_back({{r * std::cos(angle), r * std::sin(angle), -1.0}, {0.0, 0.0, 1.0}});
    }
    return random;
}

std::vector<TraceResult> traced(const Fields& fields, const std::vector<TraceRay>& rays) {
    return traceRays(sharedContext(), fields, effectsOf({}, fields), {}, rays);
}

} // namespace

void expectSceneProperties(std::uint64_t seed) {
    const std::string text = randomScene(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ":\n" << text);
    // Matter differs from voxel to voxel at these resolutions, so that the grid's own sum says little about the ledger.
    constexpr double kAnyShare = 1e3;
    const HardCase hard = bakedCase(text);
    expectSound(hard, kAnyShare);
    const RenderResult picture = renderedCase(hard);
    expectSound(picture);
    const HardCase again = bakedCase(text);
    EXPECT_EQ(again.bake.light.irradiance.values, hard.bake.light.irradiance.values);
    EXPECT_EQ(renderedCase(again).channel("R").values, picture.channel("R").values);
}

void expectRayProperties(std::uint64_t seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << randomIndex(seed));
    const auto [fields, there] = randomField(seed);
    std::vector<TraceRay> back;
    const auto ends = traced(fields, there);
    for (const TraceResult& end : ends) back.push_back({end.position, -end.direction});
    const auto starts = traced(fields, back);
    for (std::size_t i = 0; i < there.size(); ++i) {
        // The step on the way back falls elsewhere: what is left is twice the error of steps of 0.75 voxel on linear voxels,
        // 0.05 voxels of 1/16. A ray that is caught has no way back.
        if (ends[i].status != TraceStatus::kExited) continue;
        EXPECT_LE(glm::length(starts[i].position - there[i].origin), 0.05 * 2.0) << "ray " << i;
        EXPECT_NEAR(starts[i].opticalLength, ends[i].opticalLength, 1e-2) << "ray " << i;
    }
}

} // namespace eikonal::test

// Light that is baked while the scene changes ends as the light that one bake of the last scene leaves.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "common/gpu/context.h"
#include "common/scene_toml.h"
#include "lightsim/bake.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/window/live_bake.h"

namespace eikonal::window {
namespace {

const std::string kScene = R"(
[domain]
resolution = 40
[medium]
scattering = 0.3
[[object]]
shape = "sphere"
ior = 1.5
[[light]]
type = "directional"
)";

BakeRequest requestFor(const std::vector<std::string>& overrides, std::shared_ptr<const Fields> fields = {}) {
    BakeRequest request;
    request.scene = parseScene(kScene, "a.toml", ".", overrides);
    request.fields = fields ? fields : std::make_shared<const Fields>(composeFields(request.scene));
    request.effects = decideEffects(request.scene, *request.fields);
    return request;
}

/// The last light that comes; `coarse`: how many coarse ones came before.
LiveLight lastLight(LiveBake& bake, int* coarse = nullptr) {
    std::optional<LiveLight> last;
    while (bake.isBusy()) {
        if (auto light = bake.take()) {
            if (coarse && light->stage == LightStage::kCoarse) ++*coarse;
            last = std::move(light);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(bake.takeError(), std::nullopt);
    EXPECT_TRUE(last);
    return last ? std::move(*last) : LiveLight{};
}

void expectLightOf(const BakeRequest& request, const LiveLight& light) {
    EXPECT_EQ(light.stage, LightStage::kScene);
    const BakeResult once = bakeScene(test::sharedContext(), request.scene, *request.fields, request.effects, {});
    EXPECT_EQ(light.light.irradiance.values, once.light.irradiance.values);
    EXPECT_EQ(light.light.lightDirection.values, once.light.lightDirection.values);
}

TEST(LiveBake, ShowsACoarseLightFirstAndEndsWithTheScenes) {
    const BakeRequest request = requestFor({});
    LiveBake bake;
    EXPECT_EQ(bake.coming(), std::nullopt);
    bake.start(request);
    EXPECT_EQ(bake.coming(), LightStage::kCoarse);
    int coarse = 0;
    const LiveLight light = lastLight(bake, &coarse);
    EXPECT_EQ(coarse, 1);
    EXPECT_EQ(bake.coming(), std::nullopt);
    expectLightOf(request, light);
}

TEST(LiveBake, EndsWithTheLastOfManyPositions) {
    const BakeRequest first = requestFor({});
    LiveBake bake;
    bake.start(first);
    BakeRequest last;
    for (const char* direction : {"[1, 0.1, 0]", "[1, 0.2, 0]", "[1, 0.3, 0.1]"}) {
        last = requestFor({std::string("light.0.direction=") + direction}, first.fields);
        bake.start(last);
        // Long enough for a coarse bake, so that fine ones are given up under way.
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }
    expectLightOf(last, lastLight(bake));
}

TEST(LiveBake, FollowsMatterAndAccuracyToo) {
    LiveBake bake;
    bake.start(requestFor({}));
    lastLight(bake);
    const BakeRequest thicker = requestFor({"object.0.ior=1.2", "accuracy.tolerance=0.1"});
    bake.start(thicker);
    expectLightOf(thicker, lastLight(bake));
}

TEST(LiveBake, BakesAtTwiceTheToleranceToCompareWith) {
    BakeRequest request = requestFor({});
    request.rough = true;
    LiveBake bake;
    EXPECT_EQ(bake.start(request), 1u);
    const LiveLight light = lastLight(bake);
    EXPECT_EQ(light.stage, LightStage::kRough);
    EXPECT_EQ(light.request, 1u);
    const BakeRequest twice = requestFor({"accuracy.tolerance=0.04"}, request.fields);
    const BakeResult once = bakeScene(test::sharedContext(), twice.scene, *twice.fields, twice.effects, {});
    EXPECT_EQ(light.light.irradiance.values, once.light.irradiance.values);
}

TEST(LiveBake, MayBeClosedAtAnyTime) {
    LiveBake bake;
    bake.start(requestFor({"domain.resolution=96", "accuracy.tolerance=0.005"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
}

} // namespace
} // namespace eikonal::window

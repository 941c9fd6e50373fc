// A change of the scene redoes what depends on it, and nothing else.
#include <gtest/gtest.h>

#include "common/scene_toml.h"
#include "viewer/window/panel.h"
#include "viewer/window/redo.h"

namespace eikonal::window {
namespace {

const std::string kScene = R"(
[[object]]
name = "ball"
[[light]]
type = "point"
)";

Scene with(const std::vector<std::string>& overrides) { return parseScene(kScene, "a.toml", ".", overrides); }

Redo after(const std::string& override) { return redoFor(with({}), with({override})); }

TEST(Redo, NothingForTheSameSceneItsNamesAndItsSize) {
    EXPECT_EQ(redoFor(with({}), with({})), Redo{});
    EXPECT_EQ(after("object.0.name=globe"), Redo{});
    EXPECT_EQ(after("render.size=[10, 10]"), Redo{});
}

TEST(Redo, OnlyWhatDependsOnTheValue) {
    EXPECT_EQ(after("camera.fov=50"), Redo{.camera = true});
    EXPECT_EQ(after("render.exposure=1"), Redo{.exposure = true});
    EXPECT_EQ(after("render.tone_map=none"), Redo{.image = true});
    EXPECT_EQ(after("light.0.power=[1, 2, 3]"), Redo{.light = true});
    EXPECT_EQ(after("accuracy.tolerance=0.1"), Redo{.light = true});
    EXPECT_EQ(after("accuracy.integrator=rk4"), Redo{.image = true});
    EXPECT_EQ(after("environment.rotate=30"), Redo{.image = true});
    const Redo all{.image = true, .fields = true, .light = true};
    EXPECT_EQ(after("object.0.ior=1.3"), all);
    EXPECT_EQ(after("domain.resolution=32"), all);
    EXPECT_EQ(after("accuracy.interpolation=cubic"), all);
    EXPECT_EQ(after("accuracy.tolerance=0.001"), all);  // where `auto` interpolates by cubics
    EXPECT_EQ(after("medium.scattering=0.5"), all);
}

TEST(Redo, AnEnvironmentThatLightsTheBakeIsLight) {
    EXPECT_EQ(redoFor(with({"environment.bake=true"}), with({"environment.bake=true", "environment.rotate=30"})),
              (Redo{.image = true, .light = true}));
}

TEST(Panel, SwitchesOneEffectAndLeavesTheOthers) {
    EffectSet effects;
    for (int i = 0; i <= int(Effect::kEnvironment); ++i) effects.decisions.push_back({Effect(i), i % 2 == 0, "", {}});
    const std::string off = effectsOverride(effects, with({}), Effect::kScattering, false);
    const Scene without = with({off});
    ASSERT_TRUE(without.render.effects);
    EXPECT_EQ(without.render.effects->size(), effects.decisions.size() - 1);
    const Scene back = with({effectsOverride(effects, without, Effect::kScattering, true)});
    EXPECT_EQ(back.render.effects->size(), effects.decisions.size());
}

} // namespace
} // namespace eikonal::window

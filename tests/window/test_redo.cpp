// A change of the scene redoes what depends on it, and nothing else.
#include <gtest/gtest.h>

#include "common/scene_toml.h"
#include "tests/support/temporary_folder.h"
#include "viewer/window/document.h"
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
    EXPECT_EQ(after("accuracy.tolerance=0.001"), (Redo{.image = true, .light = true}));  // where `auto` takes cubics in images
    EXPECT_EQ(after("accuracy.interpolation=cubic"), (Redo{.image = true, .light = true}));
    EXPECT_EQ(after("accuracy.integrator=rk4"), Redo{.image = true});
    EXPECT_EQ(after("environment.rotate=30"), Redo{.image = true});
    const Redo all{.image = true, .fields = true, .light = true};
    EXPECT_EQ(after("object.0.ior=1.3"), all);
    EXPECT_EQ(after("domain.resolution=32"), all);
    EXPECT_EQ(after("medium.scattering=0.5"), all);
}

TEST(Redo, AnEnvironmentThatLightsTheBakeIsLight) {
    EXPECT_EQ(redoFor(with({"environment.bake=true"}), with({"environment.bake=true", "environment.rotate=30"})),
              (Redo{.image = true, .light = true}));
}

TEST(Redo, AnObjectWithALatticeOfItsOwnMovesWithoutIt) {
    const Scene here = with({"object.0.resolution=40"});
    for (const char* move : {"object.0.translate=[0.1, 0, 0]", "object.0.rotate=[0, 10, 0]", "object.0.scale=0.5"}) {
        EXPECT_EQ(redoFor(here, with({"object.0.resolution=40", move})), (Redo{.insets = true, .light = true})) << move;
        EXPECT_TRUE(redoFor(with({}), with({move})).fields) << "on the domain's lattice it does not";
    }
    EXPECT_TRUE(redoFor(here, with({"object.0.resolution=41"})).fields);
    EXPECT_TRUE(redoFor(here, with({"object.0.resolution=40", "object.0.ior=1.4"})).fields);
}

TEST(Redo, WhatEffectsCostIsComparedInOneSceneOnly) {
    const Scene here = with({});
    for (const char* same : {"render.effects=[\"refraction\"]", "light.0.power=[1, 2, 3]", "render.exposure=1"}) {
        EXPECT_TRUE(differInEffectsOnly(here, with({same}))) << same;
    }
    for (const char* other : {"object.0.ior=1.3", "camera.fov=50", "accuracy.step=2", "medium.scattering=0.5"}) {
        EXPECT_FALSE(differInEffectsOnly(here, with({"render.effects=[]", other}))) << other;
    }
}

TEST(Redo, ADocumentKeepsTheGridsOfWhatMoves) {
    const test::TemporaryFolder folder;
    Document document(folder.write("scene.toml", kScene), {"object.0.resolution=40", "domain.resolution=16"});
    const auto insetOf = [&] { return document.image().fields->insets.at(0); };
    const Inset before = insetOf();
    EXPECT_TRUE(document.light().fields->insets.empty());
    document.set("object.ball.translate=[0.25, 0, 0]");
    EXPECT_EQ(insetOf().grids, before.grids);
    EXPECT_EQ(insetOf().worldFromLocal[3].x, 0.25);
    document.set("object.ball.ior=1.4");
    EXPECT_NE(insetOf().grids, before.grids);
}

TEST(Document, TellsMapsFromScenesByTheirNames) {
    for (const char* map : {"sky.hdr", "Sky.EXR", "a/b.c.HDR"}) EXPECT_TRUE(isEnvironmentMap(map)) << map;
    for (const char* other : {"sky.toml", "exr", "hdr.vdb"}) EXPECT_FALSE(isEnvironmentMap(other)) << other;
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

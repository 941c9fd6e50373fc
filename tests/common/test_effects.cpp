#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/effects.h"
#include "common/scene_summary.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

struct Decided {
    Scene scene;
    EffectSet effects;
    bool has(Effect effect) const { return effects.has(effect); }
    std::string why(Effect effect) const { return effects.decisions[std::size_t(effect)].why; }
    bool wantsLight() const { return effects.wantsLight(scene); }
};

Decided decide(const std::string& text) {
    const Scene scene = sceneOf("[domain]\nresolution = 12\n" + text);
    return {scene, decideEffects(scene, composeFields(scene))};
}

TEST(Effects, VacuumShowsOnlyTheEnvironment) {
    const Decided vacuum = decide("");
    for (int i = 0; i <= int(Effect::kEnvironment); ++i) {
        EXPECT_EQ(vacuum.effects.decisions[std::size_t(i)].effect, Effect(i)) << "in the order of the enumeration";
        EXPECT_EQ(vacuum.has(Effect(i)), Effect(i) == Effect::kEnvironment) << effectName(Effect(i));
        EXPECT_FALSE(vacuum.why(Effect(i)).empty());
    }
    EXPECT_EQ(vacuum.effects.defines(), std::vector<std::string>{"EFFECT_ENVIRONMENT"});
    EXPECT_FALSE(vacuum.wantsLight());
}

TEST(Effects, GlassRefractsAndReflectsGradientMediaOnlyRefract) {
    const Decided glass = decide("[[object]]\n");
    EXPECT_TRUE(glass.has(Effect::kRefraction));
    EXPECT_TRUE(glass.has(Effect::kReflection));
    EXPECT_FALSE(glass.has(Effect::kAbsorption));
    const Decided lens = decide("[[object]]\nshape = \"field\"\nior = \"r < 1 ? sqrt(2 - r*r) : 1\"\n");
    EXPECT_TRUE(lens.has(Effect::kRefraction));
    EXPECT_FALSE(lens.has(Effect::kReflection));
}

TEST(Effects, SurfacesAreTintedOrRoughWhereTheyReflect) {
    const Decided plain = decide("[[object]]\nroughness = 0.5\n");
    EXPECT_FALSE(plain.has(Effect::kTint));
    EXPECT_FALSE(plain.has(Effect::kRoughness)) << "of a smooth surface";
    EXPECT_TRUE(decide("[[object]]\nreflection_tint = [1, 0.8, 0.5]\n").has(Effect::kTint));
    EXPECT_TRUE(decide("[[object]]\nsurface = \"rough\"\n").has(Effect::kRoughness));
    EXPECT_FALSE(decide("[[object]]\nsurface = \"rough\"\nior = 1\n").has(Effect::kRoughness));
    EXPECT_NE(decide("[[object]]\n[accuracy]\nreflections = 2\n").why(Effect::kReflection).find("2 generations"),
              std::string::npos);
}

TEST(Effects, EachKindOfMatterCallsForItsOwn) {
    EXPECT_TRUE(decide("[[object]]\nabsorption = 1\n").has(Effect::kAbsorption));
    EXPECT_TRUE(decide("[medium]\nscattering = 1\n").has(Effect::kScattering));
    EXPECT_TRUE(decide("[[object]]\nemission = \"1 + r\"\n").has(Effect::kEmission));
    EXPECT_TRUE(decide("[[object]]\nopaque = true\n").has(Effect::kOpaque));
    // Matter outside the domain, or of no strength, calls for nothing.
    EXPECT_FALSE(decide("[[object]]\nabsorption = 1\ntranslate = [9, 0, 0]\n").has(Effect::kAbsorption));
    EXPECT_FALSE(decide("[[object]]\nscattering = \"0*x\"\n").has(Effect::kScattering));
}

TEST(Effects, LightIsSimulatedOnlyWhereItShows) {
    EXPECT_FALSE(decide("[medium]\nscattering = 1\n").wantsLight());            // nothing shines
    EXPECT_FALSE(decide("[[light]]\n[[object]]\n").wantsLight());                // nothing shows it
    EXPECT_TRUE(decide("[[light]]\n[medium]\nscattering = 1\n").wantsLight());
    EXPECT_TRUE(decide("[[light]]\n[[object]]\nopaque = true\n").wantsLight());
    const std::string underSky = "[environment]\nbake = true\n[medium]\nscattering = 1\n";
    EXPECT_TRUE(decide(underSky).wantsLight());
    EXPECT_FALSE(decide(underSky + "[render]\neffects = [\"scattering\"]\n").wantsLight());  // the sky is left out
}

TEST(Effects, TheSceneMayLeaveEffectsOut) {
    const std::string text = "[[light]]\n[[object]]\nabsorption = 1\n[medium]\nscattering = 1\n";
    const Decided some = decide(text + "[render]\neffects = [\"refraction\", \"emission\"]\n");
    EXPECT_TRUE(some.has(Effect::kRefraction));
    EXPECT_FALSE(some.has(Effect::kScattering));
    EXPECT_FALSE(some.has(Effect::kEmission)) << "allowed, but nothing emits";
    EXPECT_NE(some.why(Effect::kScattering).find("left out by render.effects"), std::string::npos);
    EXPECT_FALSE(some.wantsLight());
    EXPECT_EQ(some.effects.defines(), std::vector<std::string>{"EFFECT_REFRACTION"});
}

TEST(SceneSummary, CountsBytesOfWhatIsOn) {
    const Scene scene = sceneOf("[domain]\nresolution = 10\n[[light]]\n[medium]\nscattering = 1\n[render]\n"
                                "size = [20, 10]\nsamples = 2\n");
    const nlohmann::json summary = sceneSummary(scene, composeStageFields(scene));
    EXPECT_EQ(summary["lattice"]["voxels"], 1000);
    EXPECT_EQ(summary["memory_bytes"], 1000 * 16);  // three bands of scattering and g, float
    EXPECT_EQ(summary["cost"]["image_rays"], 400);
    EXPECT_EQ(summary["cost"]["image_steps"], 4000);
    EXPECT_EQ(summary["cost"]["bake_patch_steps"], 1000);
    const Scene many = sceneOf("[domain]\nresolution = 10\n[[light]]\n[[light]]\ntype = \"rectangle\"\nsamples = 4\n"
                               "[medium]\nscattering = 1\n[environment]\nbake = true\nlights = 8\n");
    // one beam and eight of the sky at a patch for each voxel, four points at three faces for each layer
    EXPECT_EQ(sceneSummary(many, composeStageFields(many))["cost"]["bake_patch_steps"], 9 * 1000 + 4 * 3 * 1000);
    for (const auto& row : summary["effects"])
        EXPECT_EQ(row["bytes"].get<int>(), row["name"] == "scattering" ? 16000 : 0) << row;
}

} // namespace
} // namespace eikonal

// The environment lights the bake: a white one from all sides, with what its map holds.
#include <numbers>

#include "lightsim/per_light.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Scene underWhiteSky(int lights) {
    Scene scene;
    scene.environment.gradient = {glm::dvec3(1.0), glm::dvec3(1.0)};
    scene.environment.bake = true;
    scene.environment.lights = lights;
    return scene;
}

TEST(EnvironmentLight, OfRadianceOneGivesFourPi) {
    const BakeResult result = test::bake(underWhiteSky(64), test::uniformFields(test::cube(16, 1.0)));
    const double truth = 4.0 * std::numbers::pi;
    double sum = 0.0;
    int count = 0;
    for (int k = 2; k < 14; ++k) {
        for (int j = 2; j < 14; ++j) {
            for (int i = 2; i < 14; ++i) {
                const double irradiance = result.light.irradiance.at(i, j, k).x;
                EXPECT_NEAR(irradiance, truth, 0.1 * truth);  // of one beam a tenth at worst (test_beam.cpp)
                // opposite arrivals cancel, as far as the regions of the map are mirror images
                EXPECT_LT(glm::length(result.light.lightDirection.at(i, j, k)), 0.05);
                sum += irradiance;
                ++count;
            }
        }
    }
    EXPECT_NEAR(sum / count, truth, 0.005 * truth);
}

TEST(EnvironmentLight, IsLeftOutWithItsEffectOrItsKey) {
    const Fields fields = test::uniformFields(test::cube(8, 1.0));
    Scene without = underWhiteSky(4);
    without.render.effects = std::vector<std::string>{"scattering"};
    EXPECT_EQ(test::bake(without, fields).statistics.energy.emitted, glm::dvec3(0.0));
    Scene off = underWhiteSky(4);
    off.environment.bake = false;
    EXPECT_EQ(test::bake(off, fields).statistics.energy.emitted, glm::dvec3(0.0));
}

TEST(PerLight, PartsAddUpToTheBakeOfAllLights) {
    Scene scene = underWhiteSky(4);
    scene.lights = {DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(3.0, 2.0, 1.0)}, PointLight{{0.2, 0.1, 0.0}, glm::dvec3(5.0)}};
    const Fields fields = test::absorbingSphereInSmoke(16);
    const EffectSet effects = decideEffects(scene, fields);
    LightSimulator simulator(test::sharedContext(), scene, fields, effects, {});
    const LightSet lights = lightsAt(lightsOf(scene, effects), 0.0);
    const BakeResult apart = bakePerLight(simulator, lights);
    const BakeResult together = simulator.bake(lights);
    ASSERT_EQ(apart.parts.size(), 3u);
    EXPECT_EQ(apart.parts[0].name, "light0");
    EXPECT_EQ(apart.parts[1].name, "light1");
    EXPECT_EQ(apart.parts[2].name, "environment");
    for (std::size_t i = 0; i < together.light.irradiance.values.size(); ++i) {
        const glm::vec3 whole = together.light.irradiance.values[i];
        glm::vec3 sum(0.0f);
        for (const NamedLight& part : apart.parts) {
            sum += part.light.irradiance.values[i];
        }
        // the same patches in other units of fixed point
        EXPECT_LT(glm::length(sum - whole), 1e-5f * glm::length(whole));
        EXPECT_LT(glm::length(apart.light.irradiance.values[i] - whole), 1e-5f * glm::length(whole));
        EXPECT_LT(glm::length(apart.light.lightDirection.values[i] - together.light.lightDirection.values[i]), 1e-4f);
    }
    EXPECT_EQ(apart.statistics.patches.steps, together.statistics.patches.steps);
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(apart.statistics.energy.scattered[band], together.statistics.energy.scattered[band],
                    1e-5 * together.statistics.energy.scattered[band]);
    }
}

} // namespace
} // namespace eikonal

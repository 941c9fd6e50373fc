// In grey matter lights of one colour are baked as grey light, in one band, and have their colour all the same.
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Fields greySphereInSmoke(int resolution) {
    Fields fields = test::absorbingSphereInSmoke(resolution);
    for (glm::vec3& sigma : fields.sigmaA.values) {
        sigma = glm::vec3(sigma.y);
    }
    return fields;
}

Scene litBy(const glm::dvec3& colour, const glm::dvec3& otherColour) {
    Scene scene;
    scene.lights = {DirectionalLight{{1.0, 0.0, 0.0}, 3.0 * colour}, PointLight{{-0.2, 0.8, 0.1}, 5.0 * otherColour}};
    return scene;
}

/// Of sums in fixed point, of which a voxel has at least thousands of units, and of single precision.
constexpr float kRounding = 1e-5f;

void expectColour(const BakeResult& result, const BakeResult& white, const glm::vec3& colour) {
    for (std::size_t i = 0; i < white.light.irradiance.values.size(); ++i) {
        const glm::vec3 expected = colour * white.light.irradiance.values[i];
        EXPECT_LE(glm::length(result.light.irradiance.values[i] - expected), kRounding * glm::length(expected));
        EXPECT_LE(glm::length(result.light.lightDirection.values[i] - white.light.lightDirection.values[i]), kRounding);
    }
    const auto expectRow = [&](const glm::dvec3& found, const glm::dvec3& ofWhite) {
        const glm::dvec3 expected = glm::dvec3(colour) * ofWhite;
        EXPECT_LE(glm::length(found - expected), double(kRounding) * glm::length(expected));
    };
    expectRow(result.statistics.energy.emitted, white.statistics.energy.emitted);
    expectRow(result.statistics.energy.absorbed, white.statistics.energy.absorbed);
    expectRow(result.statistics.energy.scattered, white.statistics.energy.scattered);
    expectRow(result.statistics.energy.reflected, white.statistics.energy.reflected);
}

TEST(LightColour, OfAllLightsIsAFactorOfWhiteLight) {
    const Fields fields = greySphereInSmoke(24);
    const BakeResult white = test::bake(litBy(glm::dvec3(1.0), glm::dvec3(1.0)), fields);
    for (const glm::dvec3& colour : {glm::dvec3(0.9, 0.7, 0.3), glm::dvec3(0.2, 0.3, 1.7), glm::dvec3(0.0, 1.0, 0.0)}) {
        const BakeResult result = test::bake(litBy(colour, colour), fields);
        expectColour(result, white, glm::vec3(colour));
        EXPECT_EQ(result.statistics.memoryBytes, white.statistics.memoryBytes);  // of one band
    }
}

TEST(LightColour, OfOneLightAloneIsItsOwn) {
    const Fields fields = greySphereInSmoke(24);
    const glm::dvec3 red(1.0, 0.25, 0.125), blue(0.125, 0.25, 1.0);
    const BakeResult white = test::bake(litBy(glm::dvec3(1.0), glm::dvec3(1.0)), fields);
    const BakeResult result = test::bake(litBy(red, blue), fields);
    EXPECT_GT(result.statistics.memoryBytes, white.statistics.memoryBytes);  // of three bands
    const BakeResult ofRed = test::bake(litBy(red, glm::dvec3(0.0)), fields), ofBlue = test::bake(litBy(glm::dvec3(0.0), blue), fields);
    for (std::size_t i = 0; i < result.light.irradiance.values.size(); ++i) {
        const glm::vec3 sum = ofRed.light.irradiance.values[i] + ofBlue.light.irradiance.values[i];
        // tubes are resolved to the strongest band of each light: both bakes launch the same rays
        EXPECT_LE(glm::length(result.light.irradiance.values[i] - sum), kRounding * glm::length(sum));
    }
}

TEST(LightColour, MattersBandByBandInColouredMatter) {
    const Fields fields = test::absorbingSphereInSmoke(24);
    const glm::dvec3 colour(0.9, 0.7, 0.3);
    const BakeResult white = test::bake(litBy(glm::dvec3(1.0), glm::dvec3(1.0)), fields);
    const BakeResult result = test::bake(litBy(colour, colour), fields);
    EXPECT_EQ(result.statistics.memoryBytes, white.statistics.memoryBytes);  // of three bands, both
    for (std::size_t i = 0; i < white.light.irradiance.values.size(); ++i) {
        const glm::vec3 expected = glm::vec3(colour) * white.light.irradiance.values[i];
        EXPECT_LE(glm::length(result.light.irradiance.values[i] - expected), kRounding * glm::length(expected));
    }
}

} // namespace
} // namespace eikonal

// The environment as directional lights: what the map holds, no more and no less, wherever it is cut.
#include <gtest/gtest.h>

#include <numbers>

#include "common/environment_lights.h"

namespace eikonal {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 sumOf(const std::vector<DirectionalLight>& lights) {
    glm::dvec3 sum(0.0);
    for (const DirectionalLight& light : lights) {
        sum += light.irradiance;
    }
    return sum;
}

glm::dvec3 integralOf(const EnvironmentCells& cells) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < cells.size().y; ++y) {
        for (int x = 0; x < cells.size().x; ++x) {
            sum += cells.radiance(x, y) * cells.solidAngle(y);
        }
    }
    return sum;
}

/// A map with structure everywhere: every pixel differs from its neighbours.
Image patternedMap() {
    Image map{{64, 32}, {}};
    for (int i = 0; i < 64 * 32; ++i) {
        map.pixels.emplace_back(float(i * 37 % 101) / 50.0f, float(i * 53 % 89) / 40.0f, float(i * 71 % 97) / 30.0f);
    }
    return map;
}

TEST(EnvironmentCells, SolidAnglesFillTheSphere) {
    const Environment environment;
    const Image map = patternedMap();
    for (const Image* image : {static_cast<const Image*>(nullptr), &map}) {
        const EnvironmentCells cells(environment, image);
        double sum = 0.0;
        for (int y = 0; y < cells.size().y; ++y) {
            sum += cells.solidAngle(y) * cells.size().x;
        }
        EXPECT_NEAR(sum, 4.0 * kPi, 1e-12);
    }
}

TEST(EnvironmentCells, TurnWithTheMapAndScaleWithItsIntensity) {
    Environment environment;
    environment.intensity = 2.5;
    const Image map = patternedMap();
    const EnvironmentCells cells(environment, &map);
    EXPECT_LT(glm::distance(cells.radiance(5, 7), 2.5 * glm::dvec3(map.at(5, 7))), 1e-12);
    const glm::dvec3 still = cells.direction(5, 7);
    environment.rotate = 90.0;  // what was at +Z is seen at +X (test_physics.cpp)
    const glm::dvec3 turned = cells.direction(5, 7);
    EXPECT_NEAR(turned.x, still.z, 1e-12);
    EXPECT_NEAR(turned.y, still.y, 1e-12);
    EXPECT_NEAR(turned.z, -still.x, 1e-12);
}

TEST(EnvironmentLights, SumToTheIntegralOfTheMap) {
    Environment environment;
    environment.intensity = 1.7;
    const Image map = patternedMap();
    for (const Image* image : {static_cast<const Image*>(nullptr), &map}) {
        const EnvironmentCells cells(environment, image);
        const glm::dvec3 integral = integralOf(cells);
        for (const int count : {1, 2, 7, 64, 500}) {
            const auto lights = environmentLights(cells, count);
            EXPECT_EQ(int(lights.size()), count);
            EXPECT_LT(glm::distance(sumOf(lights), integral), 1e-12 * glm::length(integral)) << count;
        }
    }
}

TEST(EnvironmentLights, OfAGradientHoldItsClosedForm) {
    Environment environment;
    environment.gradient = {glm::dvec3(0.5, 1.0, 2.0), glm::dvec3(3.0, 2.0, 1.0)};
    const auto lights = environmentLights(EnvironmentCells(environment, nullptr), 64);
    // the horizon below, and above it the mean of both ends, because it is linear in the sine of the elevation
    const glm::dvec3 truth =
        2.0 * kPi * (environment.gradient[0] + 0.5 * (environment.gradient[0] + environment.gradient[1]));
    EXPECT_LT(glm::distance(sumOf(lights), truth), 1e-4 * glm::length(truth));  // midpoints of 128 rows: (π/128)²/24
}

TEST(EnvironmentLights, OfAWhiteSkyAreEquallyStrong) {
    Environment environment;
    environment.gradient = {glm::dvec3(1.0), glm::dvec3(1.0)};
    const auto lights = environmentLights(EnvironmentCells(environment, nullptr), 64);
    glm::dvec3 flux(0.0);
    for (const DirectionalLight& light : lights) {
        // cuts fall between cells: of a region's 16 rows or columns, over six cuts
        EXPECT_NEAR(light.irradiance.x, 4.0 * kPi / 64.0, 0.15 * 4.0 * kPi / 64.0);
        EXPECT_NEAR(glm::length(light.direction), 1.0, 1e-12);
        flux += light.direction * light.irradiance.x;
    }
    EXPECT_LT(glm::length(flux), 0.02 * 4.0 * kPi) << "as much from each side";
}

TEST(EnvironmentLights, LieWhereTheMapIsBright) {
    Image map{{64, 32}, std::vector<glm::vec3>(64 * 32, glm::vec3(0.0f))};
    map.pixels[std::size_t(10 * 64 + 20)] = glm::vec3(100.0f, 50.0f, 20.0f);
    const Environment environment;
    const EnvironmentCells cells(environment, &map);
    const auto lights = environmentLights(cells, 16);
    ASSERT_EQ(lights.size(), 1u) << "black regions give no light";
    EXPECT_LT(glm::distance(lights[0].direction, -cells.direction(20, 10)), 1e-12);
    EXPECT_NEAR(lights[0].irradiance.x, 100.0 * cells.solidAngle(10), 1e-12);
    const Image black{{4, 2}, std::vector<glm::vec3>(8, glm::vec3(0.0f))};
    EXPECT_TRUE(environmentLights(EnvironmentCells(environment, &black), 16).empty());
}

} // namespace
} // namespace eikonal

// Irradiance of a point light in vacuum: Φ/(4πr²), travelling away from it, wherever the light is.
#include <numbers>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

struct Errors {
    double rms, bias, direction;
};

/// Relative errors of the voxels at distances between `near` and `far` from the light.
Errors errorsAround(const PointLight& light, const BakedLight& baked, double near, double far) {
    double squares = 0.0, sum = 0.0, worstCosine = 1.0;
    int count = 0;
    const Lattice& lattice = baked.lattice;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 offset = lattice.worldFromIndex(v) - light.position;
        const double r = glm::length(offset);
        if (r < near || r > far) return;
        const double truth = light.power.x / (4.0 * std::numbers::pi * r * r);
        const double error = baked.irradiance.at(v).x / truth - 1.0;
        squares += error * error;
        sum += error;
        worstCosine = std::min(worstCosine, glm::dot(glm::dvec3(baked.lightDirection.at(v)), offset / r));
        ++count;
    });
    return {std::sqrt(squares / count), sum / count, 1.0 - worstCosine};
}

TEST(PointLight, FallsWithTheSquareOfDistance) {
    const PointLight light{{0.013, -0.021, 0.017}, glm::dvec3(10.0)};
    const BakeResult result = test::bake(test::sceneWith(light), test::uniformFields(test::cube(64, 1.0)));
    const Errors errors = errorsAround(light, result.light, 0.3, 0.9);
    EXPECT_LE(errors.rms, 0.003);             // the promise at default accuracy
    EXPECT_LE(std::abs(errors.bias), 0.001);  // a cube's mean is above its middle by (h/r)²/12, 1e-3 at 0.3
    // a twentieth of the 1.27 million patch-steps of a splat with patches of a voxel and steps of half of one
    EXPECT_LE(result.statistics.patches.steps, 63500u);
    const auto& values = result.light.irradiance.values;
    EXPECT_EQ(std::count_if(values.begin(), values.end(), [](const glm::vec3& e) { return e.x <= 0.0f; }), 0);
    EXPECT_LE(errors.direction, 0.005);       // 0.3 away a voxel spans 6 degrees: its mean direction is shorter by 0.1 %
}

/// Once the light about a lamp was left to lines the farther from it the finer the tolerance was, and they err by chance.
TEST(PointLight, ErrsNoMoreAtAFinerTolerance) {
    const PointLight light{{0.1, 0.2, 0.3}, glm::dvec3(10.0)};
    Scene scene = test::sceneWith(light);
    for (const double tolerance : {0.02, 0.005, 0.002}) {
        scene.accuracy.tolerance = tolerance;
        const BakeResult result = test::bake(scene, test::uniformFields(test::cube(32, 1.0)));
        const Errors errors = errorsAround(light, result.light, 0.32, 1.2);  // five voxels off and more
        // At the least distance a cube's mean is above its middle by (h/r)²/12, 0.32 %; lines erred by 1 and 3 % on the average.
        EXPECT_LE(errors.rms, 0.005) << tolerance;
    }
}

TEST(PointLight, ScalesWithPower) {
    const Fields fields = test::uniformFields(test::cube(24, 1.0));
    const BakeResult one = test::bake(test::sceneWith(PointLight{{0.1, 0.2, 0.3}, glm::dvec3(1.0)}), fields);
    const BakeResult many = test::bake(test::sceneWith(PointLight{{0.1, 0.2, 0.3}, glm::dvec3(1e9)}), fields);
    for (std::size_t i = 0; i < one.light.irradiance.values.size(); ++i) {
        // fixed-point units scale with the power: only the rounding of the scale itself (2^-24) differs
        EXPECT_NEAR(many.light.irradiance.values[i].x * 1e-9, one.light.irradiance.values[i].x,
                    1e-6 * one.light.irradiance.values[i].x);
    }
}

TEST(PointLight, OutsideTheDomainLightsItAll) {
    // seen through a window, just off a face, and so far away that it is a beam
    for (const glm::dvec3& position : {glm::dvec3(4.0, 1.5, -2.0), glm::dvec3(1.05, 0.2, 0.1), glm::dvec3(0.0, 1e6, 0.0)}) {
        const PointLight light{position, glm::dvec3(10.0)};
        const BakeResult result = test::bake(test::sceneWith(light), test::uniformFields(test::cube(32, 1.0)));
        const Errors errors = errorsAround(light, result.light, 0.3, 1e300);
        EXPECT_LE(errors.rms, 0.03) << position.x;  // the outermost voxels, clipped by the silhouette, dominate
        EXPECT_LE(std::abs(errors.bias), 0.003) << position.x;
    }
}

TEST(PointLight, LedgerHoldsAllItsPower) {
    const BakeResult result = test::bake(test::sceneWith(PointLight{{0.0, 0.0, 0.0}, glm::dvec3(1.0, 2.0, 3.0)}),
                                         test::uniformFields(test::cube(16, 1.0)));
    const EnergyLedger& energy = result.statistics.energy;
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(energy.entered[band], 1.0 + band, 1e-5 * (1.0 + band));  // 3 x 3 Gauss points: 1e-6 of a solid angle
        EXPECT_NEAR(energy.exited[band], 1.0 + band, 1e-5 * (1.0 + band));
    }
}

} // namespace
} // namespace eikonal

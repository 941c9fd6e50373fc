// Spot lights: the profile's closed form on the axis, darkness outside the cone, all the power accounted for.
#include <numbers>

#include "lightsim/point_source.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

SpotLight spotAt(const glm::dvec3& position, double angle) {
    SpotLight spot;
    spot.position = position;
    spot.direction = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
    spot.power = glm::dvec3(10.0);
    spot.angle = angle;
    return spot;
}

/// Φ over the solid angle of the sharp cone that holds as much, over r².
double axialIrradiance(const SpotLight& spot, double r) {
    const double half = glm::radians(0.5 * spot.angle);
    const double meanCosine = 0.5 * (std::cos(half) + std::cos(half * (1.0 - spot.blend)));
    return spot.power.x / (2.0 * std::numbers::pi * (1.0 - meanCosine) * r * r);
}

/// Angle of a voxel's centre to the axis [radians].
double angleOf(const SpotLight& spot, const glm::dvec3& x) {
    const glm::dvec3 offset = x - spot.position;
    return std::atan2(glm::length(glm::cross(offset, spot.direction)), glm::dot(offset, spot.direction));
}

/// Mean ratio to the closed form near the axis.
double meanAxialRatio(const SpotLight& spot, const BakedLight& baked, double near, double far) {
    double sum = 0.0;
    int count = 0;
    const double flat = 0.5 * glm::radians(0.5 * spot.angle) * (1.0 - spot.blend);
    test::forEachVoxel(baked.lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = baked.lattice.worldFromIndex(v);
        const double r = glm::distance(x, spot.position);
        if (r < near || r > far || angleOf(spot, x) > flat) return;
        sum += baked.irradiance.at(v).x / axialIrradiance(spot, r);
        ++count;
    });
    return sum / count;
}

TEST(SpotLight, OnItsAxisHasTheClosedFormOfItsProfile) {
    const Fields fields = test::uniformFields(test::cube(48, 1.0));
    // launched through a window about the cone, from a cube about the light, and through a window towards the domain
    for (const SpotLight& spot : {spotAt({-0.2, -0.1, -0.7}, 50.0), spotAt({0.02, 0.01, -0.3}, 160.0),
                                  spotAt({-1.2, -0.8, -4.0}, 80.0)}) {
        const BakeResult result = test::bake(test::sceneWith(spot), fields);
        const bool inside = spot.position.z > -1.0;
        const double near = inside ? 0.4 : 3.5;
        // bias of a point light at default accuracy (test_point_light.cpp), over fewer voxels
        EXPECT_NEAR(meanAxialRatio(spot, result.light, near, inside ? 1.0 : 4.5), 1.0, 0.005) << spot.angle;
    }
}

TEST(SpotLight, IsDarkOutsideItsCone) {
    const SpotLight spot = spotAt({-0.2, -0.1, -0.7}, 50.0);
    const BakeResult result = test::bake(test::sceneWith(spot), test::uniformFields(test::cube(48, 1.0)));
    const Lattice& lattice = result.light.lattice;
    int dark = 0;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        // a voxel's hat reaches √3 voxels along its diagonal, a patch with a corner in the cone 1.15 √2 beyond it
        const double reach = 3.4 * lattice.voxel / glm::distance(x, spot.position);
        if (reach < 1.0 && angleOf(spot, x) - std::asin(reach) > glm::radians(0.5 * spot.angle)) {
            EXPECT_EQ(result.light.irradiance.at(v), glm::vec3(0.0f));
            ++dark;
        }
    });
    EXPECT_GT(dark, 50000);
}

TEST(SpotLight, LedgerHoldsAllItsPower) {
    const Fields fields = test::uniformFields(test::cube(32, 1.0));
    for (const double angle : {3.0, 50.0, 120.0, 200.0, 360.0}) {
        SpotLight spot = spotAt({0.1, -0.1, -0.2}, angle);
        spot.power = glm::dvec3(1.0, 2.0, 3.0);
        const EnergyLedger energy = test::bake(test::sceneWith(spot), fields).statistics.energy;
        EXPECT_EQ(energy.emitted, spot.power);
        for (int band = 0; band < 3; ++band) {
            // corners stand for the mean of a patch: the trapezoidal rule over cells of a 64th of the window
            EXPECT_NEAR(energy.entered[band], spot.power[band], 2e-3 * spot.power[band]) << angle;
            EXPECT_NEAR(energy.exited[band] + energy.culled[band], energy.entered[band], 1e-5 * spot.power[band]);
        }
    }
}

TEST(SpotLight, WithASharpEdgeLosesNothing) {
    SpotLight spot = spotAt({0.1, -0.1, -0.2}, 60.0);
    spot.blend = 0.0;
    const EnergyLedger energy =
        test::bake(test::sceneWith(spot), test::uniformFields(test::cube(32, 1.0))).statistics.energy;
    // the edge is known to about a quarter of a cell, at random along it: 64 cells across, 200 around
    EXPECT_NEAR(energy.entered.x, spot.power.x, 5e-3 * spot.power.x);
}

TEST(SpotLight, OfAFullTurnWithoutFadingIsAPointLight) {
    SpotLight spot = spotAt({0.1, -0.1, -0.2}, 360.0);
    spot.blend = 0.0;
    const bake::PointSource source = bake::pointSourceOf(spot);
    EXPECT_NEAR(source.intensity.x, spot.power.x / (4.0 * std::numbers::pi), 1e-12);
    EXPECT_EQ(source.shareAlong(glm::dvec3(1.0, 0.0, 0.0)), 1.0);
}

} // namespace
} // namespace eikonal

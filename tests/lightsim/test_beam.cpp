// Parallel beams: uniform in vacuum, exponential in an absorber, additive, and dark without light.
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

TEST(Beam, IsUniformInVacuum) {
    for (const glm::dvec3& direction : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(1.0, 0.3, -0.2)}) {
        const BakeResult result = test::bake(test::sceneWith(DirectionalLight{glm::normalize(direction), glm::dvec3(2.0)}),
                                             test::uniformFields(test::cube(32, 1.0)));
        double sum = 0.0;
        for (int k = 2; k < 30; ++k) {
            for (int j = 2; j < 30; ++j) {
                for (int i = 2; i < 30; ++i) {
                    const double irradiance = result.light.irradiance.at(i, j, k).x;
                    sum += irradiance;
                    EXPECT_NEAR(irradiance, 2.0, 2e-3);
                    EXPECT_NEAR(glm::length(result.light.lightDirection.at(i, j, k)), 1.0, 1e-4);
                }
            }
        }
        EXPECT_NEAR(sum / (28.0 * 28.0 * 28.0), 2.0, 0.004);
    }
}

TEST(Beam, IsEvenWhereCellsEndBetweenSamplesOrOnThem) {
    // along an axis the faces of cells lie at multiples of the step, and samples at sixths, quarters or eighths of a voxel
    for (const double stepVoxels : {0.5, 1.0, 1.25, 1.5}) {
        for (const double tolerance : {0.005, 0.02, 0.08}) {
            Scene scene = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});
            scene.accuracy.stepVoxels = stepVoxels;
            scene.accuracy.tolerance = tolerance;
            const BakeResult result = test::bake(scene, test::uniformFields(test::cube(16, 1.0)));
            const auto [least, most] = std::minmax_element(
                result.light.irradiance.values.begin(), result.light.irradiance.values.end(),
                [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; });
            // rounding: of a cell's map, and of sums in fixed point
            EXPECT_NEAR(least->x, 1.0f, 1e-4) << stepVoxels << ", " << tolerance;
            EXPECT_NEAR(most->x, 1.0f, 1e-4) << stepVoxels << ", " << tolerance;
        }
    }
}

/// Cells share faces on which samples may lie, whatever the direction: each counts once. What is left is the rounding of rays, a
/// ten-thousandth of a voxel: where a face comes as near to samples, as along (1, 2, 3) in 48 voxels, a few miss one or have it twice.
TEST(Beam, IsEvenAlongEveryDirection) {
    const std::vector<glm::dvec3> directions{{1.0, 1.0, 1.0}, {1.0, -1.0, 1.0}, {1.0, 1.0, 0.5}, {1.0, 2.0, 3.0},
                                             {0.3, 0.5, 0.9}, {1.0, 0.2, -0.1}};
    for (const int resolution : {24, 48, 64}) {
        for (const glm::dvec3& direction : directions) {
            const Scene scene = test::sceneWith(DirectionalLight{glm::normalize(direction), glm::dvec3(1.0)});
            const BakeResult result = test::bake(scene, test::uniformFields(test::cube(resolution, 1.0)));
            int uneven = 0;
            for (const glm::vec3& irradiance : result.light.irradiance.values) {
                const float off = std::abs(irradiance.x - 1.0f);
                uneven += off > 1e-3f ? 1 : 0;
                EXPECT_LT(off, 1.5f / 27.0f) << "more than one sample of 27";
            }
            EXPECT_LE(uneven, 2e-4 * double(result.light.irradiance.values.size())) << resolution << " " << direction.x << " " << direction.y << " " << direction.z;
        }
    }
}

TEST(Beam, FallsExponentiallyInAnAbsorber) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.sigmaA = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.5f, 1.0f, 2.0f));
    const BakeResult result = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), fields);
    const glm::dvec3 sigma(0.5, 1.0, 2.0);
    for (int i = 1; i < 31; ++i) {
        const double depth = (i + 0.5) * lattice.voxel;
        const glm::dvec3 truth = glm::exp(-sigma * depth);
        for (int band = 0; band < 3; ++band) {
            // hat against point value of the exponential: (sigma h)^2/6 = 3e-3 of it where sigma is 2
            EXPECT_NEAR(result.light.irradiance.at(i, 16, 16)[band], truth[band], 5e-3 * truth[band]);
        }
    }
    const EnergyLedger& energy = result.statistics.energy;
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(energy.absorbed[band], 4.0 * (1.0 - std::exp(-2.0 * sigma[band])), 1e-3);
        EXPECT_NEAR(energy.depositedAbsorbed[band], energy.absorbed[band], 5e-3 * energy.absorbed[band]);
    }
}

TEST(Beam, AddsToOthers) {
    const Fields fields = test::uniformFields(test::cube(16, 1.0));
    Scene scene;
    scene.lights = {DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0, 0.0, 0.0)},
                    DirectionalLight{{-1.0, 0.0, 0.0}, glm::dvec3(0.0, 0.0, 1.0)}};
    const BakeResult result = test::bake(scene, fields);
    const glm::vec3 irradiance = result.light.irradiance.at(8, 8, 8);
    EXPECT_NEAR(irradiance.x, 1.0, 0.01);
    EXPECT_EQ(irradiance.y, 0.0f);
    EXPECT_NEAR(irradiance.z, 1.0, 0.01);
    // equal and opposite arrivals: no flux
    EXPECT_NEAR(glm::length(result.light.lightDirection.at(8, 8, 8)), 0.0, 0.01);
}

TEST(Beam, LeavesDarknessWithoutLightOrPower) {
    const Fields fields = test::uniformFields(test::cube(8, 1.0));
    for (const Scene& scene : {Scene{}, test::sceneWith(PointLight{{0.0, 0.0, 0.0}, glm::dvec3(0.0)})}) {
        const BakeResult result = test::bake(scene, fields);
        for (const glm::vec3& irradiance : result.light.irradiance.values) {
            EXPECT_EQ(irradiance, glm::vec3(0.0f));
        }
        EXPECT_EQ(result.statistics.energy.balance(), glm::dvec3(0.0));
    }
}

TEST(Beam, IsStoppedByOpaqueMatter) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    // voxels 8 to 23 across, 14 to 17 along the beam
    fields.opaque = test::boxCoverage(lattice, {-0.125, -0.5, -0.5}, {0.125, 0.5, 0.5});
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.8f));
    const BakeResult result = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), fields);
    const auto irradiance = [&](int i, int j, int k) { return result.light.irradiance.at(i, j, k).x; };
    EXPECT_NEAR(irradiance(12, 16, 16), 1.0, 0.02);  // no power is lost in front of the wall
    EXPECT_EQ(irradiance(15, 16, 16), 0.0f);         // none inside it
    EXPECT_EQ(irradiance(24, 16, 16), 0.0f);         // nor behind it
    EXPECT_NEAR(irradiance(24, 4, 16), 1.0, 0.02);   // and all beside it
    const EnergyLedger& energy = result.statistics.energy;
    // the wall is 16 patches wide and its edges are known to half a patch each: (1 + 1/16)^2 - 1
    EXPECT_NEAR(energy.absorbedOpaque.x, 1.0, 0.13);
    EXPECT_NEAR(energy.absorbedOpaque.x + energy.exited.x, energy.entered.x, 1e-5);
}

} // namespace
} // namespace eikonal

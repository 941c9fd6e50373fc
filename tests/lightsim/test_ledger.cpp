// Energy: what enters is absorbed, scattered, reflected or leaves, and the written grid says the same independently.
#include <numbers>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

TEST(Ledger, BalancesAndAgreesWithTheGrid) {
    const BakeResult result = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}),
                                         test::absorbingSphereInSmoke(48));
    const EnergyLedger& energy = result.statistics.energy;
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(energy.entered[band], energy.emitted[band], 1e-3 * energy.emitted[band]);
        EXPECT_NEAR(energy.balance()[band], 0.0, 0.002);
        EXPECT_NEAR(energy.depositedAbsorbed[band], energy.absorbed[band], 0.005 * energy.absorbed[band]);
        EXPECT_NEAR(energy.depositedScattered[band], energy.scattered[band], 0.005 * energy.scattered[band]);
        EXPECT_GT(energy.reflected[band], 0.0);
        EXPECT_LT(energy.culled[band], 0.005 * energy.entered[band]);  // light caught in total reflection
    }
}

/// Rays about the rim of the domain, as the light sees it, stand for what meets it: not for all of their cells or for nothing.
TEST(Ledger, CountsWhatMeetsTheDomain) {
    const double towardsCorner = 4.0 * std::sqrt(3.0);                 // the box's projection
    const double fromAbove = 10.0 * std::asin(0.5) / std::numbers::pi;  // 4 asin(1/2) sr are the upper face's
    for (const int resolution : {8, 16, 32}) {
        const Lattice lattice = test::cube(resolution, 1.0);
        Fields fields = test::uniformFields(lattice);
        fields.sigmaS = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.2f));
        const auto expectEntered = [&](const Light& light, double power) {
            const EnergyLedger energy = test::bake(test::sceneWith(light), fields).statistics.energy;
            // 16 x 16 places of each cell that the rim crosses: as a row along it, a thirty-second of such a cell at most.
            EXPECT_NEAR(energy.entered.x, power, 1e-3 * power) << resolution;
            EXPECT_NEAR(energy.balance().x, 0.0, 1e-6) << resolution;
        };
        expectEntered(DirectionalLight{glm::normalize(glm::dvec3(1.0)), glm::dvec3(1.0)}, towardsCorner);
        expectEntered(PointLight{.position = {0.0, 2.0, 0.0}, .power = glm::dvec3(10.0), .keyframes = {}}, fromAbove);
    }
}

/// A slab of index 1.5, |x - shift| < 0.4, across the domain.
Fields glassSlab(double shiftVoxels = 0.0) {
    const Lattice lattice = test::cube(48, 1.0);
    const double width = 1.5 * lattice.voxel;
    const auto distance = [&](const glm::dvec3& x) { return std::abs(x.x - shiftVoxels * lattice.voxel) - 0.4; };
    Fields fields = test::indexFields(
        lattice, [&](const glm::dvec3& x) { return 1.0 + 0.25 * std::erfc(distance(x) / (std::sqrt(2.0) * width)); });
    fields.interface = DenseGrid<unsigned char>(lattice.size, 0);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        fields.interface.at(v) = std::abs(distance(lattice.worldFromIndex(v))) < 2.75 * width ? 255 : 0;
    });
    return fields;
}

TEST(Ledger, CountsFresnelLossOncePerCrossing) {
    // a beam straight through: (1 - R)^2 is transmitted, with R = 0.04 at each of the faces
    const Fields fields = glassSlab();
    const BakeResult result = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), fields);
    // the band ends where 0.3 % of the step is left: R is known to 2 x 0.3 % / 0.5 of itself
    EXPECT_NEAR(result.statistics.energy.exited.x / result.statistics.energy.entered.x, 0.96 * 0.96, 0.002);
    EXPECT_NEAR(result.light.irradiance.at(24, 24, 24).x, 0.96, 0.01);
}

TEST(Ledger, LosesAtABoundaryWhereTheGridDoes) {
    for (const double shiftVoxels : {0.0, 0.25, 0.5, 0.75}) {
        Fields fields = glassSlab(shiftVoxels);
        fields.sigmaA = test::boxGrid(fields.lattice, {-0.4, -2.0, -2.0}, {0.4, 2.0, 2.0}, glm::vec3(1.0f, 0.2f, 0.05f));
        const EnergyLedger energy =
            test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), fields).statistics.energy;
        for (int band = 0; band < 3; ++band) {
            // In a step of 19 a twenty-fifth of the light is lost: were it lost at the step's end, half of that would be between
            // the two, 0.1 %. The rest is where the face lies between voxels, 0.035 % at the most.
            EXPECT_NEAR(energy.depositedAbsorbed[band], energy.absorbed[band], 5e-4 * energy.absorbed[band]) << shiftVoxels;
        }
    }
}

} // namespace
} // namespace eikonal

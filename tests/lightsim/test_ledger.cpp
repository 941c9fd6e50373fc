// Energy: what enters is absorbed, scattered, reflected or leaves, and the written grid says the same independently.
#include <numbers>
#include <random>

#include "lightsim/ledger.h"
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

/// A trilinear interpolant at a place [voxels from the first one's middle], clamped at the faces.
double trilinearAt(const DenseGrid<glm::vec3>& grid, const glm::dvec3& place) {
    const glm::ivec3 base(glm::floor(place));
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 share = glm::mix(1.0 - (place - glm::dvec3(base)), place - glm::dvec3(base), glm::dvec3(side));
        sum += share.x * share.y * share.z * double(grid.at(glm::clamp(base + side, glm::ivec3(0), grid.size - 1)).x);
    }
    return sum;
}

double depositedAbsorbed(const DenseGrid<glm::vec3>& sigmaA, const DenseGrid<glm::vec3>& irradiance) {
    Fields fields = test::uniformFields(test::cube(sigmaA.size.x, 1.0));
    fields.sigmaA = sigmaA;
    EnergyLedger ledger;
    const BakedLight light{fields.lattice, irradiance, DenseGrid<glm::vec3>(sigmaA.size, glm::vec3(0.0f))};
    bake::integrateDeposits(fields, bake::VoxelMean::kCube, light, ledger);
    return ledger.depositedAbsorbed.x;
}

TEST(Ledger, IntegratesLightThatIsLinearExactly) {
    constexpr int kSize = 6;
    const Lattice lattice = test::cube(kSize, 1.0);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0.0f, 3.0f);
    DenseGrid<glm::vec3> sigma(lattice.size, glm::vec3(0.0f)), irradiance = sigma;
    const auto light = [](const glm::dvec3& place) { return 4.0 + 0.25 * place.x - 0.125 * place.y + 0.5 * place.z; };
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::ivec3 inner = glm::clamp(v, glm::ivec3(2), glm::ivec3(kSize - 3));  // slopes at the faces are one-sided
        sigma.at(v) = glm::vec3(inner == v ? uniform(random) : 0.0f);
        irradiance.at(v) = glm::vec3(light(glm::dvec3(v)));
    });
    // Two Gauss points along each axis of an eighth of a voxel are exact: there the product is quadratic in each.
    const double offset = 0.25 / std::sqrt(3.0);
    double truth = 0.0;
    test::forEachVoxel(test::cube(4 * kSize, 1.0), [&](const glm::ivec3& point) {
        const glm::dvec3 middle = 0.25 + 0.5 * glm::dvec3(point / 2) - 0.5;
        const glm::dvec3 place = middle + offset * (2.0 * glm::dvec3(point % 2) - 1.0);
        truth += trilinearAt(sigma, place) * light(place) / 64.0;
    });
    truth *= std::pow(lattice.voxel, 3);
    EXPECT_NEAR(depositedAbsorbed(sigma, irradiance), truth, 1e-12 * truth);  // rounding: all values are exact in floats
}

TEST(Ledger, FindsNothingAbsorbedWhereNoLightIs) {
    const glm::ivec3 size(12);
    DenseGrid<glm::vec3> wall(size, glm::vec3(0.0f));
    for (int i = 6 * 12 * 12; i < 12 * 12 * 12; ++i) {
        wall.values[std::size_t(i)] = glm::vec3(5.0f);
    }
    for (int layer = 0; layer < 12; ++layer) {  // a beam of one voxel along the wall's face, before it and in it
        DenseGrid<glm::vec3> beam(size, glm::vec3(0.0f));
        for (int i = 0; i < 12; ++i) {
            beam.at(i, 6, layer) = glm::vec3(1.0f);
        }
        const double length = 2.0, section = std::pow(2.0 / 12.0, 2);
        // The absorption rises from the middle of the last voxel before the wall to that of the first one in it.
        const double sigma = layer < 5 ? 0.0 : layer == 5 ? 0.125 * 5.0 : layer == 6 ? 0.875 * 5.0 : 5.0;
        EXPECT_NEAR(depositedAbsorbed(wall, beam), sigma * length * section, 1e-12) << layer;
    }
}

} // namespace
} // namespace eikonal

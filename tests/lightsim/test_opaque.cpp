// Opaque matter in the light's way: light is taken up in front of it and ends on it, in the ledger and on the grid.
#include <array>
#include <numbers>

#include "common/depth.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

const glm::dvec3 kSigma(1.0, 2.0, 0.4);  // by band [1 / scene unit]

/// Absorbing matter all over the domain, and opaque matter in it.
Fields absorberWith(const Lattice& lattice, DenseGrid<float> opaque) {
    Fields fields = test::uniformFields(lattice);
    fields.sigmaA = DenseGrid<glm::vec3>(lattice.size, glm::vec3(kSigma));
    fields.opaque = std::move(opaque);
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.8f));
    return fields;
}

BakeResult bakeBeam(const Fields& fields, const glm::dvec3& direction = {1.0, 0.0, 0.0}) {
    return test::bake(test::sceneWith(DirectionalLight{glm::normalize(direction), glm::dvec3(1.0)}), fields);
}

double absorbedByMedium(const EnergyLedger& energy, int band) { return energy.absorbed[band] - energy.absorbedOpaque[band]; }

/// By free shares of the voxels that the wall's face cuts.
class WallAt : public ::testing::TestWithParam<double> {};

TEST_P(WallAt, EndsTheLightAtItsFace) {
    const Lattice lattice = test::cube(32, 1.0);
    const int cut = 10;
    const double face = lattice.min.x + (cut + GetParam()) * lattice.voxel;
    DenseGrid<float> depths(lattice.size, 0.0f);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        depths.at(v) = float(depthFromDistance((face - lattice.worldFromIndex(v).x) / lattice.voxel));
    });
    const BakeResult result = bakeBeam(absorberWith(lattice, std::move(depths)));
    const EnergyLedger& energy = result.statistics.energy;
    const double depth = face - lattice.min.x;
    for (int band = 0; band < 3; ++band) {
        const double truth = 4.0 * (1.0 - std::exp(-kSigma[band] * depth));
        EXPECT_NEAR(absorbedByMedium(energy, band), truth, 1e-3 * truth);
        // what light the cut voxels hold stands for all that is free of them
        EXPECT_NEAR(energy.depositedAbsorbed[band], truth, 1e-3 * truth);
        const double irradiance = std::exp(-kSigma[band] * (depth - 0.5 * GetParam() * lattice.voxel));
        // the mean over the samples in front of the face is that of a place up to an eighth of a voxel off
        const double shift = kSigma[band] * lattice.voxel / 8.0;
        EXPECT_NEAR(result.light.irradiance.at(cut, 16, 16)[band], irradiance, (shift + 0.005) * irradiance);
        EXPECT_EQ(result.light.irradiance.at(cut + 1, 16, 16)[band], 0.0f);
    }
    EXPECT_NEAR(energy.balance().x, 0.0, 1e-5);
}

// Not where the face is as far in as a layer of samples, a voxel of four: whether these are lit is chance then.
INSTANTIATE_TEST_SUITE_P(FreeShares, WallAt, ::testing::Values(0.25, 0.4, 0.55, 0.7, 0.9));

TEST(Opaque, WallAcrossAnObliqueBeamIsLitEvenly) {
    const Lattice lattice = test::cube(32, 1.0);
    for (const double free : {0.6, 0.85}) {
        const double face = lattice.min.x + (16 + free) * lattice.voxel;
        Fields fields = absorberWith(lattice, test::boxCoverage(lattice, {face, -2.0, -2.0}, {2.0, 2.0, 2.0}));
        fields.sigmaA = {};
        const BakeResult result = bakeBeam(fields, {1.0, 0.5, 0.2});
        double sum = 0.0, squares = 0.0;
        int voxels = 0;
        for (int k = 8; k < 24; ++k) {
            for (int j = 14; j < 28; ++j) {  // the face is lit where the beam enters from the side x = -1
                const double irradiance = result.light.irradiance.at(16, j, k).x;
                sum += irradiance;
                squares += (irradiance - 1.0) * (irradiance - 1.0);
                ++voxels;
            }
        }
        SCOPED_TRACE(free);
        // Three layers of samples at least are free of the wall, and it may be half a layer further off than they say: a sixth.
        EXPECT_NEAR(sum / voxels, 1.0, 1.0 / 6.0);
        EXPECT_LT(std::sqrt(squares / voxels), 1.0 / 6.0);
    }
}

TEST(Opaque, FloorUnderAnObliqueBeamNeedsNoMoreRaysThanUnderAStraightOne) {
    const Lattice lattice = test::cube(64, 1.0);
    Fields fields = absorberWith(lattice, test::boxCoverage(lattice, {-2.0, -2.0, -2.0}, {2.0, -0.7, 2.0}));
    const BakeResult straight = bakeBeam(fields, {0.0, -1.0, 0.0});
    const BakeResult oblique = bakeBeam(fields, {0.7, -1.0, 0.3});
    // Neighbours meet the floor one after the other; that is no shadow between them. Measured: three times as many, for the launch
    // grid is twice as large, and rays are halved at the floor's ends and where a window of steps ends between neighbours. With a
    // shadow everywhere it was seven times.
    EXPECT_LT(oblique.statistics.patches.fieldEvaluations, 5 * straight.statistics.patches.fieldEvaluations);
    const double cosine = 1.0 / glm::length(glm::dvec3(0.7, 1.0, 0.3));
    const int floor = 9;  // layers of voxels: the tenth is cut by its surface
    for (const int layer : {floor + 1, floor + 2, floor + 5}) {
        const double depth = 1.0 - (lattice.min.y + (layer + 0.5) * lattice.voxel);
        double squares = 0.0;
        int voxels = 0;
        for (int k = 34; k < 60; ++k) {
            for (int i = 46; i < 60; ++i) {  // far enough from the sides that the beam comes through the top
                for (int band = 0; band < 3; ++band, ++voxels) {
                    const double truth = std::exp(-kSigma[band] * depth / cosine);
                    squares += std::pow(oblique.light.irradiance.at(i, layer, k)[band] / truth - 1.0, 2.0);
                }
            }
        }
        EXPECT_LT(std::sqrt(squares / voxels), 0.01) << layer;  // measured: 0.0066 at the most
    }
    for (int band = 0; band < 3; ++band) {
        const EnergyLedger& energy = oblique.statistics.energy;
        EXPECT_NEAR(energy.depositedAbsorbed[band], absorbedByMedium(energy, band), 5e-3 * absorbedByMedium(energy, band));
    }
}

/// What a unit beam along x loses in the absorber in front of, beside and behind a ball about the origin, in a domain of edge 2.
double absorbedAbout(double radius, double sigma) {
    constexpr int kRings = 4000;
    double absorbed = (4.0 - std::numbers::pi * radius * radius) * (1.0 - std::exp(-2.0 * sigma));
    for (int i = 0; i < kRings; ++i) {
        const double r = radius * (i + 0.5) / kRings;
        const double path = 1.0 - std::sqrt(radius * radius - r * r);
        absorbed += 2.0 * std::numbers::pi * r * (radius / kRings) * (1.0 - std::exp(-sigma * path));
    }
    return absorbed;
}

TEST(Opaque, BallInAnAbsorberLeavesWhatItShouldInFrontOfIt) {
    const Lattice lattice = test::cube(32, 1.0);
    DenseGrid<float> opaque(lattice.size, 0.0f);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) { opaque.at(v) = float(test::sphereCoverage(lattice, v, 0.5)); });
    const EnergyLedger energy = bakeBeam(absorberWith(lattice, std::move(opaque))).statistics.energy;
    for (int band = 0; band < 3; ++band) {
        const double truth = absorbedAbout(0.5, kSigma[band]);
        // a shadow's edge known to a tenth of a voxel is 0.4 % of the cross-section, and the ball hides a third of the path
        EXPECT_NEAR(absorbedByMedium(energy, band), truth, 2e-3 * truth);
        EXPECT_NEAR(energy.depositedAbsorbed[band], truth, 2e-3 * truth);
        EXPECT_NEAR(energy.depositedAbsorbed[band], absorbedByMedium(energy, band), 1e-3 * truth);
    }
}

} // namespace
} // namespace eikonal

// Small things between the rays of the launch mesh, which start four voxels apart.
#include <cmath>

#include "lightsim/tubes/detail.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

constexpr float kDepth = 0.5f;  // of the voxel that absorbs

/// Vacuum with one voxel of matter.
Fields speckAt(const Lattice& lattice, const glm::ivec3& voxel) {
    Fields fields = test::uniformFields(lattice);
    fields.sigmaA = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f));
    fields.sigmaA.at(voxel) = glm::vec3(kDepth / float(lattice.voxel));
    return fields;
}

/// Power that a beam along x with unit irradiance loses to the voxel, interpolated linearly: 1 - exp(-depth) over the
/// rays that meet it, by midpoints. In areas of a voxel.
double absorbedAreas() {
    constexpr int kPoints = 200;
    double sum = 0.0;
    for (int j = 0; j < kPoints; ++j) {
        for (int k = 0; k < kPoints; ++k) {
            const double y = (j + 0.5) / kPoints, z = (k + 0.5) / kPoints;
            sum += 1.0 - std::exp(-kDepth * (1.0 - y) * (1.0 - z));
        }
    }
    return 4.0 * sum / (kPoints * kPoints);
}

TEST(Detail, OfOneVoxelIsSeenWhereverItLies) {
    const Lattice lattice = test::cube(32, 1.0);
    const double truth = absorbedAreas() * lattice.voxel * lattice.voxel;
    for (int shift = 0; shift < 8; ++shift) {
        SCOPED_TRACE(shift);
        const glm::ivec3 speck(16, 12 + shift, 12 + 3 * shift % 8);
        const EnergyLedger energy = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}),
                                               speckAt(lattice, speck)).statistics.energy;
        // rays a voxel apart sum a hat that is two wide, and is no hat any more for its exponential
        EXPECT_NEAR(energy.absorbed.x, truth, 0.1 * truth);
        EXPECT_NEAR(energy.depositedAbsorbed.x, truth, 0.1 * truth);
    }
}

TEST(Detail, IsWhereTheFieldsChangeFromVoxelToVoxel) {
    const Lattice lattice = test::cube(64, 1.0);
    const auto none = [](const Fields& fields) { return !bake::isAnywhere(bake::distanceToDetail(fields)); };
    EXPECT_TRUE(none(test::uniformFields(lattice, 1.5)));
    EXPECT_TRUE(none(test::indexFields(lattice, [](const glm::dvec3& x) { return 2.0 / (1.0 + glm::dot(x, x)); })));
    const auto distance = bake::distanceToDetail(speckAt(lattice, {9, 30, 63}));
    EXPECT_EQ(distance.at(2, 7, 15), 0);
    EXPECT_EQ(distance.at(5, 7, 15), 3);
    EXPECT_EQ(distance.at(5, 7, 10), 5);
}

} // namespace
} // namespace eikonal

// Grids whose axes are not the domain's: rotated, sheared, mirrored. They hold the same index, so light finds the same.
#include <cmath>
#include <numbers>

#include <openvdb/openvdb.h>

#include "tests/stability/hard_cases.h"
#include "tests/support/temporary_folder.h"

namespace eikonal {
namespace {

constexpr double kWidth = 0.12;

double ball(const glm::dvec3& x) {
    return 1.0 + 0.25 * std::erfc((glm::length(x) - 0.5) / (std::numbers::sqrt2 * kWidth));
}

/// The ball on a grid of voxels whose matrix is given, about the origin.
void writeBall(const std::string& file, const openvdb::Mat4d& worldFromIndex) {
    openvdb::initialize();
    auto grid = openvdb::FloatGrid::create(1.0f);
    grid->setName("ior");
    grid->setTransform(openvdb::math::Transform::createLinearTransform(worldFromIndex));
    constexpr int kReach = 24;
    for (auto at = openvdb::CoordBBox(openvdb::Coord(-kReach), openvdb::Coord(kReach)).begin(); at; ++at) {
        const openvdb::Vec3d world = grid->indexToWorld(*at);
        grid->tree().setValueOn(*at, float(ball({world.x(), world.y(), world.z()})));
    }
    openvdb::io::File(file).write({grid});
}

openvdb::Mat4d matrixOf(const glm::dmat3& axes) {
    openvdb::Mat4d matrix = openvdb::Mat4d::identity();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) matrix(row, column) = axes[row][column];  // rows are images of the axes
    }
    return matrix;
}

TEST(StableTransforms, RotatedShearedAndMirroredGrids) {
    const double h = 0.07, c = std::cos(0.6), s = std::sin(0.6);
    const struct { const char* name; glm::dmat3 axes; } kGrids[] = {
        {"rotated", glm::dmat3(c, s, 0, -s * c, c * c, s, s * s, -s * c, c)},
        {"sheared", glm::dmat3(1, 0, 0, 0.5, 1, 0, 0.2, -0.3, 1)},
        {"mirrored", glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)},
        {"stretched", glm::dmat3(1, 0, 0, 0, 0.5, 0, 0, 0, 1)}};
    for (const auto& [name, axes] : kGrids) {
        SCOPED_TRACE(name);
        const test::TemporaryFolder folder;
        writeBall(folder.file("ball.vdb"), matrixOf(h * axes));
        const test::HardCase hard = test::bakedCase(
            test::kSmoke + "[[object]]\nvolume = '" + folder.file("ball.vdb") + "'\nscattering = 0.3\n[[light]]\n");
        double largest = 0.0;
        const Lattice& lattice = hard.fields.lattice;
        test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
            const glm::dvec3 x = lattice.worldFromIndex(v);
            if (glm::length(x) < 0.8) largest = std::max(largest, std::abs(double(hard.fields.ior.at(v)) - ball(x)));
        });
        // linear interpolation: an eighth of the square of the cell's longest diagonal times n'' <= 0.5 e^(-1/2)/(√(2π) b²)
        const double diagonal = h * (glm::length(axes[0]) + glm::length(axes[1]) + glm::length(axes[2]));
        EXPECT_LE(largest, diagonal * diagonal / 8.0 * 0.5 * 0.2420 / (kWidth * kWidth));
        test::expectSound(hard);
        test::expectSound(test::renderedCase(hard));
    }
}

} // namespace
} // namespace eikonal

#include "common/voxelize.h"

#include <algorithm>
#include <cmath>

#include "common/mesh_generate.h"
#include "common/vdb_io.h"
#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

TEST(Voxelize, IndexOfASphereFollowsTheCoverage) {
    const VoxelizedMesh result = voxelize(generateIcosphere(5), {.ior = 1.6, .resolution = 48});
    const Lattice& lattice = result.lattice;
    EXPECT_EQ(std::max({lattice.size.x, lattice.size.y, lattice.size.z}), 48);
    double worst = 0.0;
    for (int k = 0; k < lattice.size.z; ++k)
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i) {
                const double d = glm::length(lattice.worldFromIndex({i, j, k})) - 1.0;
                const double exact = 1.0 + 0.6 * 0.5 * std::erfc(d / (std::sqrt(2.0) * 1.5 * lattice.voxel));
                worst = std::max(worst, std::abs(exact - double(result.ior.at(i, j, k))));
            }
    // The facets' 4e-4, 0.6 % of a voxel, times the steepest index, 0.6 / (sqrt(2 pi) 1.5) per voxel; twice for the frame
    // that the facets shrink.
    EXPECT_LT(worst, 2e-3);
    EXPECT_EQ(result.ior.at(lattice.size / 2), 1.6f) << "uniform inside";
    EXPECT_NEAR(result.ior.at(0, 0, 0), 1.0f, 1e-6f);
    EXPECT_NEAR(result.voxelizedVolume / result.meshVolume, 1.0, 2e-3);
    EXPECT_TRUE(result.warnings.empty());
}

TEST(Voxelize, AbsorptionIsByArea) {
    const VoxelizedMesh result =
        voxelize(generateIcosphere(4), {.resolution = 40, .absorption = glm::dvec3(1.0, 2.0, 4.0)});
    glm::dvec3 sum(0.0);
    for (const glm::vec3& a : result.absorption.values)
        sum += glm::dvec3(a);
    const double cell = std::pow(result.lattice.voxel, 3);
    for (int band = 0; band < 3; ++band)  // the integral of absorption is its constant times the volume
        EXPECT_NEAR(sum[band] * cell / (std::exp2(band) * result.meshVolume), 1.0, 3e-3);
}

TEST(Voxelize, VoxelSizeSetsTheGrid) {
    const Lattice lattice = latticeAround({glm::dvec3(0.0), glm::dvec3(1.0, 0.5, 0.25)},
                                          {.voxelSize = 0.1, .paddingVoxels = 3});
    EXPECT_EQ(lattice.size, glm::ivec3(16, 11, 9));
    EXPECT_LT(glm::length(lattice.min + 0.5 * lattice.extent() - glm::dvec3(0.5, 0.25, 0.125)), 1e-12);
}

TEST(Voxelize, ReportsThinWallsWithTheResolutionThatResolvesThem) {
    Mesh shell = generateIcosphere(4);
    const std::size_t half = shell.triangles.size();
    const int shift = int(shell.vertices.size());
    for (int v = 0; v < shift; ++v)
        shell.vertices.push_back(0.96 * shell.vertices[std::size_t(v)]);
    for (std::size_t t = 0; t < half; ++t)
        shell.triangles.push_back(glm::ivec3(shell.triangles[t].x, shell.triangles[t].z, shell.triangles[t].y) + shift);
    const VoxelizedMesh coarse = voxelize(shell, {.resolution = 50});
    ASSERT_FALSE(coarse.warnings.empty());
    EXPECT_NE(coarse.warnings.back().find("two voxels"), std::string::npos) << coarse.warnings.back();
    const int wanted = coarse.walls.resolutionForTwoVoxels(2.0) + 14;
    EXPECT_NE(coarse.warnings.back().find("--resolution " + std::to_string(wanted)), std::string::npos);
    const VoxelizedMesh fine = voxelize(shell, {.resolution = wanted});
    EXPECT_TRUE(fine.warnings.empty());
}

TEST(Voxelize, RefusesOptionsOutOfRange) {
    const Mesh sphere = generateIcosphere(1);
    expectError(ExitCode::kUsage, "refractive index", [&] { voxelize(sphere, {.ior = 0.0}); });
    expectError(ExitCode::kUsage, "resolution", [&] { voxelize(sphere, {.resolution = 4}); });
    expectError(ExitCode::kUsage, "voxel size", [&] { voxelize(sphere, {.voxelSize = -1.0}); });
    expectError(ExitCode::kUsage, "larger voxel", [&] { voxelize(sphere, {.voxelSize = 1e-6}); });
    expectError(ExitCode::kUsage, "absorption", [&] { voxelize(sphere, {.absorption = glm::dvec3(-1.0)}); });
}

TEST(Voxelize, WritesNamedGridsAndHowTheyWereMade) {
    const TemporaryFolder folder;
    const VoxelizeOptions options{.ior = 1.4, .resolution = 24, .absorption = glm::dvec3(0.5)};
    const VoxelizedMesh result = voxelize(generateIcosphere(3), options);
    writeVoxelized(folder / "a.vdb", result, options, "sphere.obj");
    const VdbFile file = readVdb(folder / "a.vdb");
    ASSERT_TRUE(file.find("ior") && file.find("absorption"));
    EXPECT_EQ(file.find("ior")->size(), result.lattice.size);
    EXPECT_EQ(file.find("ior")->background.x, 1.0f);
    EXPECT_EQ(std::get<double>(file.metadata.at("eikonal_ior")), 1.4);
    EXPECT_EQ(std::get<double>(file.metadata.at("eikonal_smooth_voxels")), 1.5);
}

} // namespace
} // namespace eikonal::test

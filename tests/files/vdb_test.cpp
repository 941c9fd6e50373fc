// VDB files: what is written is read back, and other programs' files mean what they say.

#include "common/vdb_io.h"

#include <cmath>

#include <nlohmann/json.hpp>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

const Lattice kLattice{{-1.0, 2.0, 0.5}, 0.25, {9, 17, 5}};

DenseGrid<float> rampGrid() {
    DenseGrid<float> grid(kLattice.size, 1.0f);
    for (std::size_t i = 0; i < grid.values.size(); ++i)
        grid.values[i] = i % 3 == 0 ? 1.0f : 1.0f + 0.001f * float(i);  // a third equals the background
    return grid;
}

DenseGrid<glm::vec3> vectorGrid() {
    DenseGrid<glm::vec3> grid(kLattice.size, glm::vec3(0.0f));
    for (std::size_t i = 1; i < grid.values.size(); ++i)
        grid.values[i] = {float(i), -float(i), 0.5f};
    return grid;
}

void writeForeign(const std::filesystem::path& path, const openvdb::GridBase::Ptr& grid) {
    openvdb::io::File file(path.string());
    file.write({grid});
    file.close();
}

TEST(Vdb, RoundTripKeepsEveryVoxel) {
    const TemporaryFolder folder;
    const DenseGrid<float> scalar = rampGrid();
    const DenseGrid<glm::vec3> vector = vectorGrid();
    writeVdb(folder / "a.vdb", kLattice, {{"ior", &scalar, glm::vec3(1.0f)}, {"irradiance", &vector}},
             {{"creator", "a test"}, {"seconds", 1.5}});
    const VdbFile file = readVdb(folder / "a.vdb");
    ASSERT_TRUE(file.find("ior") && file.find("irradiance"));
    EXPECT_EQ(file.find("ior")->size(), kLattice.size) << "voxels equal to the background count too";
    EXPECT_EQ(file.find("ior")->scalar().values, scalar.values);
    EXPECT_EQ(file.find("irradiance")->vector().values, vector.values);
    EXPECT_EQ(file.find("ior")->background.x, 1.0f);
    EXPECT_EQ(file.find("ior")->typeName, "float");
    EXPECT_EQ(file.find("irradiance")->typeName, "vec3s");
    EXPECT_EQ(std::get<std::string>(file.metadata.at("creator")), "a test");
    EXPECT_EQ(std::get<double>(file.metadata.at("seconds")), 1.5);
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Vdb, IndexIsTheVoxelsCentre) {
    const TemporaryFolder folder;
    const DenseGrid<float> scalar = rampGrid();
    writeVdb(folder / "a.vdb", kLattice, {{"ior", &scalar, glm::vec3(1.0f)}}, {});
    const VdbFile file = readVdb(folder / "a.vdb");
    for (const glm::ivec3 index : {glm::ivec3(0), glm::ivec3(8, 16, 4)}) {
        const glm::dvec3 world(file.find("ior")->worldFromIndex * glm::dvec4(glm::dvec3(index), 1.0));
        EXPECT_LT(glm::length(world - kLattice.worldFromIndex(index)), 1e-12);  // rounding of one product
    }
    EXPECT_LT(glm::length(file.find("ior")->voxelSize() - glm::dvec3(0.25)), 1e-12);
}

TEST(Vdb, SameInputSameGridBytes) {
    const TemporaryFolder folder;
    const DenseGrid<float> scalar = rampGrid();
    writeVdb(folder / "a.vdb", kLattice, {{"ior", &scalar, glm::vec3(1.0f)}}, {});
    writeVdb(folder / "b.vdb", kLattice, {{"ior", &scalar, glm::vec3(1.0f)}}, {});
    EXPECT_EQ(readVdb(folder / "a.vdb").grids[0].scalar().values, readVdb(folder / "b.vdb").grids[0].scalar().values);
    EXPECT_EQ(readText(folder / "a.vdb").size(), readText(folder / "b.vdb").size());
}

TEST(Vdb, ReadsARotatedSparseGrid) {
    const TemporaryFolder folder;
    auto grid = openvdb::FloatGrid::create(0.25f);
    grid->setName("density");
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    auto transform = openvdb::math::Transform::createLinearTransform(0.1);
    transform->postRotate(0.5, openvdb::math::Z_AXIS);
    transform->postTranslate(openvdb::Vec3d(1.0, -2.0, 3.0));
    grid->setTransform(transform);
    grid->tree().setValueOn(openvdb::Coord(-5, 3, 7), 2.0f);
    grid->tree().setValueOn(openvdb::Coord(-3, 4, 7), 4.0f);
    writeForeign(folder / "a.vdb", grid);

    const VdbFile file = readVdb(folder / "a.vdb");
    const VdbGrid& read = file.grids.at(0);
    EXPECT_EQ(read.gridClass, VdbClass::kFogVolume);
    EXPECT_EQ(read.indexMin, glm::ivec3(-5, 3, 7));
    EXPECT_EQ(read.size(), glm::ivec3(3, 2, 1));
    EXPECT_EQ(read.scalar().at(0, 0, 0), 2.0f);
    EXPECT_EQ(read.scalar().at(2, 1, 0), 4.0f);
    EXPECT_EQ(read.scalar().at(1, 0, 0), 0.25f) << "inactive voxels hold their stored value";
    const openvdb::Vec3d expected = transform->indexToWorld(openvdb::Coord(-3, 4, 7));
    const glm::dvec3 found(read.worldFromIndex * glm::dvec4(2.0, 1.0, 0.0, 1.0));
    EXPECT_LT(glm::length(found - glm::dvec3(expected.x(), expected.y(), expected.z())), 1e-12);
}

TEST(Vdb, OtherNumbersBecomeFloat) {
    const TemporaryFolder folder;
    auto grid = openvdb::Vec3DGrid::create(openvdb::Vec3d(0.0));
    grid->setName("absorption");
    grid->tree().setValueOn(openvdb::Coord(1, 2, 3), openvdb::Vec3d(0.5, 1.5, 2.5));
    writeForeign(folder / "a.vdb", grid);
    EXPECT_EQ(readVdb(folder / "a.vdb").grids.at(0).vector().at(0, 0, 0), glm::vec3(0.5f, 1.5f, 2.5f));

    auto flags = openvdb::BoolGrid::create(false);
    flags->tree().setValueOn(openvdb::Coord(0), true);
    writeForeign(folder / "b.vdb", flags);
    EXPECT_EQ(readVdb(folder / "b.vdb").grids.at(0).scalar().at(0, 0, 0), 1.0f);
}

TEST(Vdb, NamesGridsOfOtherTypes) {
    const TemporaryFolder folder;
    auto text = openvdb::MaskGrid::create();
    text->setName("selection");
    text->tree().setValueOn(openvdb::Coord(0));
    writeForeign(folder / "a.vdb", text);
    const VdbFile file = readVdb(folder / "a.vdb");
    EXPECT_TRUE(file.grids.empty());
    ASSERT_EQ(file.skippedGrids.size(), 1u);
    EXPECT_NE(file.skippedGrids[0].find("selection"), std::string::npos);
}

TEST(Vdb, AGridWithoutActiveVoxelsIsEmpty) {
    const TemporaryFolder folder;
    auto grid = openvdb::FloatGrid::create(1.0f);
    grid->setName("ior");
    writeForeign(folder / "a.vdb", grid);
    EXPECT_TRUE(readVdb(folder / "a.vdb").grids.at(0).scalar().empty());
    EXPECT_EQ(vdbSummary(folder / "a.vdb").at("grids").at(0).at("active_voxels"), 0);
}

TEST(Vdb, SummaryTellsWhatIsInside) {
    const TemporaryFolder folder;
    const DenseGrid<float> scalar = rampGrid();
    const DenseGrid<glm::vec3> vector = vectorGrid();
    writeVdb(folder / "a.vdb", kLattice, {{"ior", &scalar, glm::vec3(1.0f)}, {"irradiance", &vector}}, {{"creator", "a test"}});
    const nlohmann::json summary = vdbSummary(folder / "a.vdb");
    EXPECT_EQ(summary.at("metadata").at("creator"), "a test");
    ASSERT_EQ(summary.at("grids").size(), 2u);
    for (const nlohmann::json& grid : summary.at("grids")) {
        EXPECT_EQ(grid.at("size"), nlohmann::json({9, 17, 5}));
        EXPECT_EQ(grid.at("active_voxels"), 9 * 17 * 5);
        for (int axis = 0; axis < 3; ++axis) {  // from the lower corner of the first voxel to the upper of the last
            EXPECT_NEAR(grid.at("world_min")[std::size_t(axis)].get<double>(), kLattice.min[axis], 1e-12);
            EXPECT_NEAR(grid.at("world_max")[std::size_t(axis)].get<double>(), kLattice.max()[axis], 1e-12);
        }
        if (grid.at("name") == "ior")
            EXPECT_EQ(grid.at("min"), 1.0);
        else
            EXPECT_EQ(grid.at("max")[0], double(9 * 17 * 5 - 1));
    }
}

TEST(Vdb, RefusesABoxTooLargeToHold) {
    const TemporaryFolder folder;
    auto grid = openvdb::FloatGrid::create(0.0f);
    grid->setName("far");
    grid->tree().setValueOn(openvdb::Coord(0), 1.0f);
    grid->tree().setValueOn(openvdb::Coord(100'000, 100'000, 100'000), 1.0f);
    writeForeign(folder / "a.vdb", grid);
    expectError(ExitCode::kBadInput, "too large", [&] { readVdb(folder / "a.vdb"); });
    EXPECT_EQ(vdbSummary(folder / "a.vdb").at("grids").at(0).at("active_voxels"), 2) << "a summary needs no dense box";
}

TEST(Vdb, ReportsAFullDisk) {
    if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "there is no /dev/full";
    const DenseGrid<float> scalar = rampGrid();
    expectError(ExitCode::kFailure, "/dev/full", [&] { writeVdb("/dev/full", kLattice, {{"ior", &scalar}}, {}); });
}

} // namespace
} // namespace eikonal::test

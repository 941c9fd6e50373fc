#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <unistd.h>

#include "common/depth.h"
#include "common/fields.h"
#include "common/mesh_generate.h"
#include "common/vdb_io.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

/// A folder for the files of one test, removed at its end.
class FieldsOfFiles : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("eikonal_" + std::to_string(getpid()) + "_" + std::string(test->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Scene scene(const std::string& text) const { return parseScene(text, "s.toml", folder_); }
    Fields fields(const std::string& text) const { return composeFields(scene(text)); }
    void write(const std::string& name, const Lattice& lattice, const std::vector<NamedGrid>& grids,
               const Metadata& metadata = {}) const {
        writeVdb(folder_ / name, lattice, grids, metadata);
    }

    std::filesystem::path folder_;
};

const Lattice kLattice{glm::dvec3(-1.0), 2.0 / 32.0, glm::ivec3(32)};

template <class Function>
DenseGrid<float> gridOf(const Lattice& lattice, const Function& function) {
    DenseGrid<float> grid(lattice.size, 0.0f);
    for (int k = 0; k < lattice.size.z; ++k)
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                grid.at(i, j, k) = float(function(lattice.worldFromIndex({i, j, k})));
    return grid;
}

double smoothSphere(const glm::dvec3& p, double radius, double b) {
    return 1.0 + 0.25 * std::erfc((glm::length(p) - radius) / (std::numbers::sqrt2 * b));
}

TEST_F(FieldsOfFiles, GivenIndexOnTheDomainsLatticeIsCopiedToTheBit) {
    const DenseGrid<float> ior = gridOf(kLattice, [](const glm::dvec3& p) { return 1.3 + 0.1 * std::sin(5.0 * p.x) * p.y; });
    write("v.vdb", kLattice, {{"ior", &ior, glm::vec3(1.0f), VdbClass::kUnknown}});
    EXPECT_EQ(fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"v.vdb\"\n").ior.values, ior.values);
    // A bare volume is a scene with the same lattice.
    const Scene bare = loadScene(folder_ / "v.vdb");
    const Fields own = composeFields(bare);
    EXPECT_EQ(own.lattice.size, kLattice.size);
    EXPECT_NEAR(own.lattice.voxel, kLattice.voxel, 1e-7);
    EXPECT_EQ(own.ior.values, ior.values);
    EXPECT_EQ(bare.lights.size(), 1u);
    EXPECT_EQ(loadScene(folder_ / "v.vdb", {"camera.fov=20"}).camera.fov, 20.0);
}

TEST_F(FieldsOfFiles, OpaqueGridIsMatterWithoutAnObjectsDistance) {
    const DenseGrid<float> half = gridOf(kLattice, [](const glm::dvec3& p) { return p.x < 0.0 ? 1.0 : 0.0; });
    write("v.vdb", kLattice, {{"opaque", &half, glm::vec3(0.0f), VdbClass::kUnknown}});
    const Fields alone = fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"v.vdb\"\n");
    EXPECT_EQ(alone.opaque.at(3, 16, 16), gpu::kMostDepth);
    EXPECT_EQ(alone.opaque.at(15, 16, 16), 1.0f);
    EXPECT_EQ(alone.opaque.at(16, 16, 16), 0.0f);
    EXPECT_EQ(alone.opaque.at(28, 16, 16), gpu::kLeastDepth);
}

TEST_F(FieldsOfFiles, LinearIndexSurvivesResampling) {
    const DenseGrid<float> ior = gridOf(kLattice, [](const glm::dvec3& p) { return 1.5 + 0.2 * p.x - 0.1 * p.z; });
    write("v.vdb", kLattice, {{"ior", &ior, glm::vec3(1.0f), VdbClass::kUnknown}});
    const Fields turned = fields("[domain]\nmin=[-0.4,-0.4,-0.4]\nmax=[0.4,0.4,0.4]\nresolution = 21\n[[object]]\n"
                                 "volume = \"v.vdb\"\nrotate = [0, 90, 0]\nscale = 0.5\n");
    // Trilinear interpolation is exact on linear functions; Ry(90°) takes local (x, z) to world (z, -x).
    for (int i = 0; i < 21; ++i) {
        const glm::dvec3 world = turned.lattice.worldFromIndex({i, 5, 12});
        const glm::dvec3 local = 2.0 * glm::dvec3(-world.z, world.y, world.x);
        EXPECT_NEAR(turned.ior.at(i, 5, 12), 1.5 + 0.2 * local.x - 0.1 * local.z, 1e-6);
    }
}

TEST_F(FieldsOfFiles, SmoothingOfAGivenIndexIsAGaussianBlur) {
    const DenseGrid<float> step = gridOf(kLattice, [](const glm::dvec3& p) { return p.x < 0.0 ? 1.5 : 1.0; });
    write("v.vdb", kLattice, {{"ior", &step, glm::vec3(1.0f), VdbClass::kUnknown}});
    const Fields blurred = fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"v.vdb\"\nsmooth = 2\n");
    for (int i = 0; i < 32; ++i) {
        const double distance = (double(i) - 15.5) / 2.0;  // in standard deviations
        // Sums of the sampled kernel are the midpoint rule: off by 0.5 max|G'| / 24 = 0.5 * 0.24 / (4 * 24) = 1.3e-3.
        EXPECT_NEAR(blurred.ior.at(i, 16, 16), 1.0 + 0.25 * std::erfc(distance / std::numbers::sqrt2), 1.4e-3);
    }
}

TEST_F(FieldsOfFiles, BoundariesOfAGivenIndexAreFoundAndGradientMediaHaveNone) {
    const double b = 1.5 * kLattice.voxel;
    const DenseGrid<float> ball = gridOf(kLattice, [&](const glm::dvec3& p) { return smoothSphere(p, 0.6, b); });
    const DenseGrid<float> lens = gridOf(kLattice, [](const glm::dvec3& p) {
        return glm::dot(p, p) < 1.0 ? std::sqrt(2.0 - glm::dot(p, p)) : 1.0;
    });
    write("ball.vdb", kLattice, {{"ior", &ball, glm::vec3(1.0f), VdbClass::kUnknown}}, {{"eikonal_smooth_voxels", 1.5}});
    write("lens.vdb", kLattice, {{"ior", &lens, glm::vec3(1.0f), VdbClass::kUnknown}});
    const Fields glass = fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"ball.vdb\"\n");
    const Fields gradient = fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"lens.vdb\"\n");
    EXPECT_TRUE(gradient.interface.empty());
    for (int k = 0; k < 32; ++k)
        for (int j = 0; j < 32; ++j)
            for (int i = 0; i < 32; ++i) {
                const double distance = std::abs(glm::length(kLattice.worldFromIndex({i, j, k})) - 0.6);
                if (distance < 2.75 * b) {
                    ASSERT_EQ(glass.interface.at(i, j, k), 255) << distance / b;
                } else if (distance > 6.0 * b) {
                    ASSERT_EQ(glass.interface.at(i, j, k), 0) << distance / b;
                }
            }
}

TEST_F(FieldsOfFiles, GlassOfAGivenIndexDisplacesTheSmokeAroundIt) {
    const double b = 1.5 * kLattice.voxel;
    const DenseGrid<float> ball = gridOf(kLattice, [&](const glm::dvec3& p) { return smoothSphere(p, 0.6, b); });
    write("ball.vdb", kLattice, {{"ior", &ball, glm::vec3(1.0f), VdbClass::kUnknown}}, {{"eikonal_smooth_voxels", 1.5}});
    const Fields fieldsWithBall = fields("[domain]\nresolution = 32\n[medium]\nscattering = 1\n[[object]]\n"
                                         "volume = \"ball.vdb\"\n");
    double smoke = 0.0;
    for (const glm::vec3& sigma : fieldsWithBall.sigmaS.values)
        smoke += double(sigma.x) * std::pow(kLattice.voxel, 3.0);
    // Coverage read off the index is the sphere's volume to a fraction of a voxel's layer: 1 % of 0.9.
    EXPECT_NEAR(8.0 - smoke, 4.0 / 3.0 * std::numbers::pi * 0.216, 0.02);
    EXPECT_FLOAT_EQ(fieldsWithBall.sigmaS.at(1, 1, 1).x, 1.0f);
    EXPECT_FLOAT_EQ(fieldsWithBall.sigmaS.at(16, 16, 16).x, 0.0f);
}

TEST_F(FieldsOfFiles, GridsMultiplyConstantsAndStandAloneWithoutThem) {
    const DenseGrid<float> half(kLattice.size, 0.5f);
    DenseGrid<glm::vec3> colored(kLattice.size, glm::vec3(1.0f, 2.0f, 3.0f));
    write("v.vdb", kLattice, {{"soot", &half, glm::vec3(0.0f), VdbClass::kUnknown},
                              {"scattering", &colored, glm::vec3(0.0f), VdbClass::kUnknown}});
    const std::string text = "[domain]\nresolution = 32\n[[object]]\nvolume = \"v.vdb\"\ngrids = { absorption = \"soot\" }\n";
    EXPECT_FLOAT_EQ(fields(text).sigmaA.at(5, 5, 5).y, 0.5f);
    EXPECT_EQ(fields(text).sigmaS.at(5, 5, 5), glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_FLOAT_EQ(fields(text + "absorption = 4\n").sigmaA.at(5, 5, 5).y, 2.0f);
    EXPECT_TRUE(fields(text).iorGradient.empty());
    const std::string missing = "[[object]]\nvolume = \"v.vdb\"\ngrids = { ior = \"index\" }\n";
    EXPECT_NE(messageOf([&] { fields(missing); }).find("expected a grid 'index'"), std::string::npos);
    const std::string vector = "[[object]]\nvolume = \"v.vdb\"\ngrids = { ior = \"scattering\" }\n";
    EXPECT_NE(messageOf([&] { fields(vector); }).find("expected a float grid for ior"), std::string::npos);
}

TEST_F(FieldsOfFiles, NarrowBandLevelSetIsTheSphereItStandsFor) {
    const double band = 3.0 * kLattice.voxel;
    const DenseGrid<float> distance = gridOf(kLattice, [&](const glm::dvec3& p) {
        return std::clamp(glm::length(p) - 0.6, -band, band);
    });
    write("v.vdb", kLattice, {{"surface", &distance, glm::vec3(float(band)), VdbClass::kLevelSet}});
    const std::string domain = "[domain]\nresolution = 32\nsmooth = 2\n[[object]]\nior = 1.5\n";
    const Fields given = fields(domain + "volume = \"v.vdb\"\n");
    const Fields formula = fields(domain + "radius = 0.6\n");
    double worst = 0.0;
    for (std::size_t v = 0; v < given.ior.values.size(); ++v)
        worst = std::max(worst, std::abs(double(given.ior.values[v]) - double(formula.ior.values[v])));
    // Beyond three voxels, 1.5 b, the distance is continued to first order: 0.1 voxel there, times the profile's slope.
    EXPECT_LT(worst, 5e-3);
    EXPECT_EQ(given.ior.at(0, 0, 0), 1.0f);
    EXPECT_NEAR(given.ior.at(16, 16, 16), 1.5, 5e-5);
}

TEST_F(FieldsOfFiles, FogIsCoverageAndLeavesTheIndex) {
    const DenseGrid<float> density = gridOf(kLattice, [](const glm::dvec3& p) { return 2.0 * p.x; });
    write("v.vdb", kLattice, {{"density", &density, glm::vec3(0.0f), VdbClass::kFogVolume}});
    const Fields fog = fields("[domain]\nresolution = 32\n[[object]]\nvolume = \"v.vdb\"\nscattering = 3\n");
    EXPECT_TRUE(fog.iorGradient.empty());
    EXPECT_EQ(fog.sigmaS.at(4, 9, 9).x, 0.0f);
    EXPECT_NEAR(fog.sigmaS.at(20, 9, 9).x, 3.0 * 2.0 * kLattice.worldFromIndex({20, 9, 9}).x, 1e-5);
    EXPECT_NEAR(fog.sigmaS.at(30, 9, 9).x, 3.0, 1e-5);
}

TEST_F(FieldsOfFiles, MeshIsTheShapeThatItsTrianglesEnclose) {
    writeObj(folder_ / "ball.obj", generateIcosphere(4));
    const std::string domain = "[domain]\nresolution = 40\n[[object]]\nior = 1.5\nabsorption = 1\n";
    const Fields mesh = fields(domain + "mesh = \"ball.obj\"\nscale = 0.6\n");
    const Fields formula = fields(domain + "radius = 0.6\n");
    for (std::size_t v = 0; v < mesh.ior.values.size(); ++v)
        // 5120 triangles lie up to 0.6 * 0.0012 inside the sphere: 0.015 voxel; the slope of n is 0.5 / (sqrt(2π) 1.5).
        ASSERT_NEAR(mesh.ior.values[v], formula.ior.values[v], 4e-3);
}

TEST_F(FieldsOfFiles, VolumesThatAreNoneSayWhatTheyHold) {
    const DenseGrid<float> other(kLattice.size, 0.5f);
    write("v.vdb", kLattice, {{"temperature", &other, glm::vec3(0.0f), VdbClass::kUnknown}});
    const std::string inScene = messageOf([&] { fields("[[object]]\nvolume = \"v.vdb\"\n"); });
    EXPECT_NE(inScene.find("found 'temperature' (float)"), std::string::npos) << inScene;
    const std::string bare = messageOf([&] { loadScene(folder_ / "v.vdb"); });
    EXPECT_NE(bare.find("expected a float grid 'ior'"), std::string::npos) << bare;
}

/// Most of what reads a grid takes its values for numbers: an infinite one once ended the program.
TEST_F(FieldsOfFiles, GridsWithValuesThatAreNoNumbersSayWhere) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const char* name : {"ior", "density", "absorption"}) {
        for (const float wrong : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
            DenseGrid<float> grid(kLattice.size, 1.3f);
            grid.at(3, 5, 7) = wrong;
            write("v.vdb", kLattice, {{name, &grid, glm::vec3(1.0f), VdbClass::kUnknown}});
            const std::string message = messageOf([&] { fields("[domain]\nresolution = 16\n[[object]]\nvolume = \"v.vdb\"\n"); });
            EXPECT_NE(message.find(std::string("finite values in grid '") + name), std::string::npos) << message;
            EXPECT_NE(message.find("(-0.78125, -0.65625, -0.53125)"), std::string::npos) << message;
        }
    }
}

TEST_F(FieldsOfFiles, WhatMeshesAreMendedOfAndWhatLiesOutsideIsSaid) {
    Mesh open = generateIcosphere(3);
    writeObj(folder_ / "ball.obj", open);
    open.triangles.pop_back();
    writeObj(folder_ / "open.obj", open);
    const std::string domain = "[domain]\nresolution = 40\n[[object]]\n";
    EXPECT_TRUE(fields(domain + "mesh = \"ball.obj\"\nscale = 0.6\n").warnings.empty());
    const auto mended = fields(domain + "mesh = \"open.obj\"\nscale = 0.6\n").warnings;
    ASSERT_EQ(mended.size(), 1u);
    EXPECT_EQ(mended[0].rfind("object 0: 3 open edges around 1 hole", 0), 0u) << mended[0];
    const auto outside = fields(domain + "name = \"moon\"\ntranslate = [5, 0, 0]\n").warnings;
    ASSERT_EQ(outside.size(), 1u);
    EXPECT_EQ(outside[0].rfind("object 'moon': no voxel of the domain has any of it", 0), 0u) << outside[0];
    EXPECT_EQ(fields(domain + "radius = 0.001\n").warnings.size(), 1u) << "too small";
    EXPECT_TRUE(fields(domain + "radius = 0.03\n").warnings.empty()) << "small, but there";
}

} // namespace
} // namespace eikonal

// Wavefronts as PLY, end to end: what the header promises is there, and patches are where the light is.

#include <cmath>
#include <cstring>
#include <sstream>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

constexpr std::size_t kVertexBytes = 3 * sizeof(float);
constexpr std::size_t kFaceBytes = 1 + 4 * sizeof(int) + 4 * sizeof(float) + 4;

/// A beam in smoke, and nothing else.
const char* const kBeamInSmoke = R"(
[domain]
resolution = 16
[medium]
scattering = 0.3
[[light]]
type = "directional"
direction = [1, 0, 0]
)";

/// A PLY as this program writes them, cut into its parts.
struct Ply {
    std::string header;
    std::size_t vertices = 0, faces = 0;
    std::string body;

    template <class T>
    T at(std::size_t offset) const {
        T value;
        std::memcpy(&value, body.data() + offset, sizeof value);
        return value;
    }
    glm::vec3 vertex(std::size_t i) const { return at<glm::vec3>(i * kVertexBytes); }
    std::size_t faceOffset(std::size_t i) const { return vertices * kVertexBytes + i * kFaceBytes; }
};

Ply readPly(const std::string& file) {
    const std::string text = readText(file);
    const std::string end = "end_header\n";
    const std::size_t size = text.find(end) + end.size();
    Ply ply{text.substr(0, size), 0, 0, text.substr(size)};
    std::istringstream lines(ply.header);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword, name;
        std::size_t count = 0;
        if (words >> keyword >> name >> count && keyword == "element") {
            (name == "vertex" ? ply.vertices : ply.faces) = count;
        }
    }
    return ply;
}

} // namespace

TEST(FrontPly, HoldsAQuadPerPatchAndItsIrradiance) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kBeamInSmoke);
    const std::string file = folder.file("front.ply");
    const RunResult result = runEikonal({"bake", "--wavefront", "0.25,0.3", scene, "-o", file});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"front.ply", "scene.toml"}));  // and no bake
    const Ply ply = readPly(file);
    EXPECT_EQ(ply.header.substr(0, 36), "ply\nformat binary_little_endian 1.0\n");
    EXPECT_EQ(ply.faces, 2u * 16u * 16u);  // patches of a voxel
    EXPECT_EQ(ply.vertices, 4 * ply.faces);
    ASSERT_EQ(ply.body.size(), ply.vertices * kVertexBytes + ply.faces * kFaceBytes);
    for (std::size_t i = 0; i < ply.faces; ++i) {
        const std::size_t face = ply.faceOffset(i);
        const float time = i < ply.faces / 2 ? 0.25f : 0.3f;
        EXPECT_EQ(ply.at<unsigned char>(face), 4);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const int index = ply.at<int>(face + 1 + corner * sizeof(int));
            EXPECT_EQ(index, int(4 * i + corner));
            EXPECT_NEAR(ply.vertex(std::size_t(index)).x, time - 1.0f, 1e-6);  // steps in single precision
        }
        EXPECT_NEAR(ply.at<float>(face + 17), std::exp(-0.3f * time), 1e-5);  // of a beam of 1
        EXPECT_EQ(ply.at<float>(face + 29), time);
        EXPECT_EQ(ply.at<unsigned char>(face + 33), 0);   // not folded
        EXPECT_NEAR(ply.at<unsigned char>(face + 34), 188, 3);  // about half the light of a display
    }
}

TEST(FrontPly, TwoRunsGiveTheSameBytes) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    for (const char* name : {"a.ply", "b.ply"}) {
        ASSERT_EQ(runEikonal({"bake", scene, "--wavefront", "1.9", "-o", folder.file(name)}).exitCode, 0);
    }
    EXPECT_GT(readPly(folder.file("a.ply")).faces, 0u);
    EXPECT_EQ(readText(folder.file("a.ply")), readText(folder.file("b.ply")));
}

TEST(FrontPly, IsAFileWithoutPatchesWhereNoLightIsLeft) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result = runEikonal({"bake", scene, "--wavefront", "1000", "-o", folder.file("dark.ply")});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const Ply ply = readPly(folder.file("dark.ply"));
    EXPECT_EQ(ply.faces, 0u);
    EXPECT_TRUE(ply.body.empty());
}

} // namespace eikonal::test

// `eikonal bake` of several lights and of lights that move.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/vdb_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

using nlohmann::json;

const std::string kMovingLamp = R"(
[[light]]
type = "point"
[[light.keyframe]]
frame = 0
position = [0, 3, 0]
[[light.keyframe]]
frame = 2
position = [0, 1, 0]
)";

bool sameGrid(const VdbFile& a, const VdbFile& b, const std::string& name) {
    return a.find(name)->vector().values == b.find(name)->vector().values;
}

} // namespace

TEST(BakeSequence, WritesAFileForEachFrame) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene + kMovingLamp);
    const RunResult result = runEikonal(
        {"bake", scene, "--frames", "3", "-o", folder.file("out_####.vdb"), "--stats", folder.file("s.json")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out_0000.vdb", "out_0001.vdb", "out_0002.vdb", "s.json",
                                                        "scene.toml"}));
    const json frames = json::parse(readText(folder.file("s.json")))["frames"];
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_GT(frames[2]["energy"]["entered"][0], 0.0);
    EXPECT_EQ(std::get<double>(readVdb(folder.path() / "out_0002.vdb").metadata.at("frame")), 2.0);
}

TEST(BakeSequence, AFrameIsTheBakeOfTheSceneWithItsLightsThere) {
    const TemporaryFolder folder;
    const std::string moving = folder.write("moving.toml", kSmallScene + kMovingLamp);
    const std::string still =
        folder.write("still.toml", kSmallScene + "[[light]]\ntype = \"point\"\nposition = [0, 2, 0]\n");
    ASSERT_EQ(runEikonal({"bake", moving, "--frames", "2", "-o", folder.file("out_#.vdb")}).exitCode, 0);
    ASSERT_EQ(runEikonal({"bake", still, "-o", folder.file("still.vdb")}).exitCode, 0);
    ASSERT_EQ(runEikonal({"bake", moving, "-o", folder.file("plain.vdb")}).exitCode, 0);
    const VdbFile second = readVdb(folder.path() / "out_1.vdb"), alone = readVdb(folder.path() / "still.vdb");
    EXPECT_TRUE(sameGrid(second, alone, "irradiance"));
    EXPECT_TRUE(sameGrid(second, alone, "light_direction"));
    EXPECT_TRUE(sameGrid(readVdb(folder.path() / "out_0.vdb"), readVdb(folder.path() / "plain.vdb"), "irradiance"));
    EXPECT_FALSE(sameGrid(second, readVdb(folder.path() / "plain.vdb"), "irradiance"));
}

TEST(BakeSequence, AnyFrameLightsThePictureOfItsScene) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene + kMovingLamp);
    ASSERT_EQ(runEikonal({"bake", scene, "--frames", "2", "-o", folder.file("##.vdb")}).exitCode, 0);
    const RunResult result = runEikonal({"render", scene, "--bake", folder.file("01.vdb"), "-o", folder.file("a.png")});
    EXPECT_EQ(result.exitCode, 0) << result.err;
}

/// Files are written while the next frame is baked.
TEST(BakeSequence, EndsWithTheFileThatCannotBeWritten) {
    for (const char* frames : {"2", "3"}) {
        const TemporaryFolder folder;
        const std::string scene = folder.write("scene.toml", kSmallScene + kMovingLamp);
        std::filesystem::create_directory(folder.path() / "out_1.vdb");
        const RunResult result = runEikonal(
            {"bake", scene, "--frames", frames, "-o", folder.file("out_#.vdb"), "--stats", folder.file("s.json")});
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_NE(result.err.find("out_1.vdb"), std::string::npos) << result.err;
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"out_0.vdb", "out_1.vdb", "scene.toml"}));
        EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "out_1.vdb"));
    }
}

TEST(BakeSequence, NeedsAPlaceForTheNumber) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result = runEikonal({"bake", scene, "--frames", "2", "-o", folder.file("out.vdb")});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("####"), std::string::npos) << result.err;
    EXPECT_EQ(runEikonal({"bake", scene, "--frames", "0", "-o", folder.file("#.vdb")}).exitCode, 2);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.toml"});
}

TEST(BakePerLight, WritesTheGridsOfEachLightAndTheirSum) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("scene.toml", kSmallScene + "[[light]]\ntype = \"spot\"\nposition = [0, 0.9, 0]\n"
                                                 "[environment]\nbake = true\nlights = 2\n");
    const RunResult result = runEikonal({"bake", scene, "--per-light", "-o", folder.file("b.vdb")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const VdbFile file = readVdb(folder.path() / "b.vdb");
    EXPECT_EQ(file.grids.size(), 8u);
    std::vector<glm::vec3> sum(16 * 16 * 16, glm::vec3(0.0f));
    for (const std::string light : {"light0", "light1", "environment"}) {
        ASSERT_NE(file.find("light_direction_" + light), nullptr) << light;
        const auto& values = file.find("irradiance_" + light)->vector().values;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += values[i];
        }
    }
    EXPECT_EQ(file.find("irradiance")->vector().values, sum);
}

TEST(BakeLights, OfEveryTypeGiveAPicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene + R"(
[[light]]
type = "spot"
position = [0, 2, 0]
[[light]]
type = "rectangle"
position = [0, 2, 0]
samples = 4
[environment]
bake = true
lights = 4
)");
    const RunResult result = runEikonal({"render", scene, "-o", folder.file("a.png")});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(runEikonal({"info", scene}).exitCode, 0);
}

} // namespace eikonal::test

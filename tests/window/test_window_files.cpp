// Files that the window reads while it is open: dropped, watched, broken; and those that it writes.
#include <filesystem>

#include "common/scene_toml.h"
#include "tests/window/window_fixture.h"

namespace eikonal::test {
namespace {

/// A ball of another index and size than the small scene's.
const std::string kOtherBall = R"(
[domain]
resolution = 16
[[object]]
radius = 0.7
ior = 1.3
)";

void makeMesh(const std::string& file) {
    const RunResult figure = runEikonal({"figure", "-o", file});
    ASSERT_EQ(figure.exitCode, 0) << figure.err;
}

void makeVolume(const std::string& mesh, const std::string& file, const std::string& ior) {
    const RunResult voxelize = runEikonal({"voxelize", mesh, "-o", file, "--ior", ior, "--resolution", "20"});
    ASSERT_EQ(voxelize.exitCode, 0) << voxelize.err;
}

TEST_F(WindowTest, ADroppedSceneTakesThePlaceOfTheOther) {
    const std::string other = folder.write("other.toml", kOtherBall);
    expectGood("0 wait\n0 drop " + other + "\n0 wait\n" + kSave + "0 quit\n");
    const ChannelImage before = rendered();
    scene = other;
    EXPECT_LT(rmsDifference(still(1), rendered()), kStillTolerance);
    EXPECT_GT(rmsDifference(still(1), before), 5.0 * kStillTolerance) << "the two scenes differ";
}

TEST_F(WindowTest, ADroppedVolumeAndADroppedMeshAreOpened) {
    const std::string mesh = folder.file("knot.obj"), volume = folder.file("knot.vdb");
    makeMesh(mesh);
    makeVolume(mesh, volume, "1.4");
    expectGood("0 drop " + volume + "\n0 set accuracy.tolerance=0.3\n0 wait\n" + kSave + "0 drop " + mesh +
               "\n0 set domain.resolution=16\n0 set accuracy.tolerance=0.3\n0 wait\n" + kSave + "0 key f2 down\n1 quit\n");
    scene = volume;
    EXPECT_LT(rmsDifference(still(1), rendered({"--set", "accuracy.tolerance=0.3"})), kStillTolerance);
    scene = folder.file("knot_0001.toml");
    EXPECT_LT(rmsDifference(still(2), rendered()), kStillTolerance) << "what was made of the mesh, as saved";
}

TEST_F(WindowTest, ADroppedMapBecomesTheEnvironment) {
    const std::string map = folder.file("sky.exr");
    const std::vector<std::string> sky{"--set", "environment.gradient=[[3, 0, 0], [0, 0, 3]]"};
    std::vector<std::string> arguments{"render", scene, "--size", "32x16", "-o", map};
    arguments.insert(arguments.end(), sky.begin(), sky.end());
    ASSERT_EQ(runEikonal(arguments).exitCode, 0);
    expectGood("0 drop " + map + "\n0 wait\n" + kSave + "0 quit\n");
    EXPECT_LT(rmsDifference(still(1), rendered({"--set", "environment.image=" + map})), kStillTolerance);
    EXPECT_GT(rmsDifference(still(1), rendered()), 5.0 * kStillTolerance) << "the map shows";
}

TEST_F(WindowTest, ASceneThatChangesIsReadAgain) {
    const std::string brighter = kSmallScene + "exposure = 2\n";
    expectGoodWhileReplacing({{"before.png", scene, brighter}}, kWithoutPanels + "0 wait\n0 screenshot before.png\n0 changed\n"
                                                                                "0 wait\n0 screenshot after.png\n1 quit\n");
    EXPECT_GT(meanOf(folder.file("after.png")), 1.2 * meanOf(folder.file("before.png"))) << "two stops";
}

TEST_F(WindowTest, AVolumeThatChangesIsReadAgain) {
    const std::string mesh = folder.file("knot.obj"), first = folder.file("first.vdb"), second = folder.file("second.vdb");
    makeMesh(mesh);
    makeVolume(mesh, first, "1.1");
    makeVolume(mesh, second, "1.8");
    const std::string shown = folder.write("knot.vdb", readText(first));
    scene = folder.write("volume.toml", "[[object]]\nvolume = \"knot.vdb\"\n[domain]\nresolution = 16\n");
    expectGoodWhileReplacing({{"first.png", shown, readText(second)}},
                             "0 wait\n" + kSave + "0 screenshot first.png\n0 changed\n0 wait\n" + kSave + "0 quit\n");
    EXPECT_LT(rmsDifference(still(2), rendered()), kStillTolerance);
    EXPECT_GT(rmsDifference(still(2), still(1)), 5.0 * kStillTolerance);
}

TEST_F(WindowTest, ABrokenFileKeepsThePictureAndSaysSoUntilItIsMended) {
    expectGoodWhileReplacing({{"good.png", scene, "[domain\n"}, {"eikonal_0001.exr", scene, kSmallScene}},
                             kWithoutPanels + "0 wait\n0 screenshot good.png\n0 changed\n2 wait\n2 screenshot broken.png\n"
                                              "3 key f12 down\n3 key f12 up\n3 wait\n3 changed\n5 wait\n"
                                              "5 screenshot mended.png\n6 quit\n",
                             {}, "not a scene file");
    EXPECT_LT(rmsDifference(still(1), rendered()), kStillTolerance) << "the picture of the scene before";
    EXPECT_EQ(errorPixels(folder.file("good.png")), 0);
    EXPECT_GT(errorPixels(folder.file("broken.png")), 100) << "a line of text";
    EXPECT_EQ(errorPixels(folder.file("mended.png")), 0);
}

TEST_F(WindowTest, ADroppedFileThatIsBrokenKeepsThePictureToo) {
    const std::string broken = folder.write("broken.toml", "[domain\n");
    expectGood(kWithoutPanels + "0 wait\n0 drop " + broken + "\n2 wait\n2 screenshot broken.png\n3 key f12 down\n3 wait\n4 quit\n",
               {}, "broken.toml:1:8: not a scene file");
    EXPECT_LT(rmsDifference(still(1), rendered()), kStillTolerance);
    EXPECT_GT(errorPixels(folder.file("broken.png")), 100) << "a line of text";
}

TEST_F(WindowTest, KernelsThatChangeAreCompiledAgainAndBrokenOnesAreNot) {
    const std::string shaders = folder.file("shaders");
    std::filesystem::copy(EIKONAL_SHADERS, shaders, std::filesystem::copy_options::recursive);
    const std::string kernel = shaders + "/viewer/picture.comp.glsl", text = readText(kernel);
    std::string red = text;
    const std::string displayed = "return srgbEncoded3(exposed);";
    ASSERT_NE(red.find(displayed), std::string::npos);
    red.replace(red.find(displayed), displayed.size(), "return vec3(1.0, 0.0, 0.0);");
    expectGoodWhileReplacing({{"own.png", kernel, red}, {"red.png", kernel, "void main() {"}},
                             kWithoutPanels + "0 wait\n0 screenshot own.png\n0 changed\n1 wait\n1 screenshot red.png\n"
                                              "1 changed\n3 wait\n3 screenshot broken.png\n4 quit\n",
                             {"--shaders", shaders}, "picture.comp.glsl");
    const glm::ivec2 besideText(140, 60);
    const auto colourIn = [&](const char* name) { return readImage(folder.file(name)).at(besideText.x, besideText.y); };
    const glm::vec3 pureRed(1.0f, 0.0f, 0.0f);
    EXPECT_NE(colourIn("own.png"), pureRed);
    EXPECT_EQ(colourIn("red.png"), pureRed);
    EXPECT_EQ(colourIn("broken.png"), pureRed) << "the kernel before goes on";
    EXPECT_GT(errorPixels(folder.file("broken.png")), 100) << "a line of text";
}

TEST_F(WindowTest, ASavedSceneKeepsCommentsAndIsTheOneThatWasSeen) {
    scene = folder.write("commented.toml", "# Why this ball.\n" + kSmallScene + "samples = 1   # enough\n");
    expectGood("0 set object.0.ior=1.3\n0 set environment.intensity=2\n0 wait\n" + kSave + "0 key f2 down\n1 quit\n");
    const std::string saved = folder.file("commented_0001.toml");
    for (const char* part : {"# Why this ball.", "samples = 1   # enough", "ior = 1.3", "size = [32, 24]"}) {
        EXPECT_NE(readText(saved).find(part), std::string::npos) << part << "\n" << readText(saved);
    }
    scene = saved;
    EXPECT_LT(rmsDifference(still(1), rendered()), kStillTolerance);
}

} // namespace
} // namespace eikonal::test

// What moves by itself, what is held down, and that nothing is left behind.
#include <cmath>
#include <filesystem>

#include "tests/window/window_fixture.h"

namespace eikonal::test {
namespace {

/// Number behind a key in a printed camera or scene.
double numberBehind(const std::string& text, const std::string& key) {
    const std::size_t at = text.rfind(key);
    EXPECT_NE(at, std::string::npos) << key << " in " << text;
    return at == std::string::npos ? 0.0 : std::stod(text.substr(at + key.size()));
}

TEST_F(WindowTest, HeldKeysFlyAndSpaceTurnsTheView) {
    const RunResult flown = view("0 key w down\n30 key w up\n30 key p down\n31 quit\n");
    ASSERT_EQ(flown.exitCode, 0) << flown.err;
    // Along the view, [0, 0, 4] to z: a second forward at 0.6 of the distance a second, which stays, in steps of a thirtieth.
    EXPECT_NEAR(numberBehind(flown.out, "position = [0, 0, "), 4.0 - 0.6 * 4.0, 0.09) << "give or take a frame";
    const RunResult turned = view("0 key space down\n0 key space up\n30 key space down\n30 key p down\n31 quit\n");
    ASSERT_EQ(turned.exitCode, 0) << turned.err;
    // Half a radian a second.
    EXPECT_NEAR(std::abs(numberBehind(turned.out, "position = [")), 4.0 * std::sin(0.5), 0.08) << "give or take a frame";
}

TEST_F(WindowTest, AnimatedLightsPlay) {
    scene = folder.write("moving.toml", kSmallScene + "[[light]]\ntype = \"point\"\npower = [200, 200, 200]\n[[light.keyframe]]\n"
                                                      "frame = 0\nposition = [0, 0.8, 0]\n[[light.keyframe]]\nframe = 48\n"
                                                      "position = [0, -0.8, 0]\n");
    // A second of 24 frames, half way.
    expectGood(kWithoutPanels + "0 wait\n0 screenshot start.png\n1 key space down\n1 key space up\n30 key space down\n"
                                "30 wait\n30 screenshot half.png\n31 quit\n");
    const Image start = readImage(folder.file("start.png")), half = readImage(folder.file("half.png"));
    EXPECT_GT(rmsDifference(start, half), 0.01) << "the light is elsewhere";
}

TEST_F(WindowTest, TheWavefrontMovesThroughThePicture) {
    expectGood(kWithoutPanels + "0 wait\n0 screenshot without.png\n1 key tab down\n1 key tab up\n1 size 700 420\n1 key 3 down\n1 key n down\n"
                                "2 wait\n30 screenshot early.png\n60 screenshot later.png\n61 quit\n");
    // Towards the light, so that the front is in the middle at all times. Right of the numbers and left of the panel, where
    // nothing else changes.
    const Image early = readImage(folder.file("early.png")), later = readImage(folder.file("later.png"));
    double change = 0.0;
    for (int y = 0; y < early.size.y; ++y) {
        for (int x = 296; x < 350; ++x) change += glm::length(early.at(x, y) - later.at(x, y));
    }
    EXPECT_GT(change, 50.0) << "the patches are elsewhere, a line of pixels at least";
}

TEST_F(WindowTest, GoesOnAfterItWasMinimised) {
    expectGood("0 wait\n0 minimise\n1 set light.0.direction=[0.6, -0.8, 0]\n5 restore\n5 wait\n5 key f12 down\n5 wait\n6 quit\n");
    EXPECT_LT(rmsDifference(still(1), rendered({"--set", "light.0.direction=[0.6, -0.8, 0]"})), kStillTolerance);
}

TEST_F(WindowTest, SavedLightIsThatOfTheSavedScene) {
    expectGood("0 set light.0.direction=[0, 1, 0]\n0 save lit.toml\n0 save lit.vdb\n0 wait\n1 quit\n");
    scene = folder.file("lit.toml");
    EXPECT_LT(rmsDifference(rendered({"--bake", folder.file("lit.vdb")}), rendered()), kStillTolerance);
}

TEST_F(WindowTest, StatisticsTellHowQuicklyItAnswered) {
    const std::string stats = folder.file("view.json");
    expectGood(kWithoutPanels + "0 wait\n1 cursor 80 90\n2 button left down\n3 cursor 90 90\n4 cursor 100 90\n5 button left up\n5 wait\n"
               "6 cursor 2 60\n7 quit\n", {"--stats", stats});
    const std::string text = readText(stats);
    EXPECT_EQ(numberBehind(text, "\"frames\": "), 2.0) << "of an orbit: " << text;
}

TEST_F(WindowTest, LeavesNoMemoryBehind) {
    if (!std::filesystem::exists(EIKONAL_LEAK_SANITIZER)) GTEST_SKIP() << "no library of LeakSanitizer for this compiler";
    RunOptions options;
    options.launcher = {"env", std::string("LD_PRELOAD=") + EIKONAL_LEAK_SANITIZER};
    const RunResult result = view(kWithoutPanels + "0 wait\n1 cursor 80 90\n2 button left down\n3 cursor 90 90\n4 button left up\n"
                                  "5 set light.0.direction=[0, 1, 0]\n6 set object.0.ior=1.3\n7 key n down\n7 key l down\n7 wait\n"
                                  "8 key v down\n9 drop " + scene + "\n9 key f12 down\n9 wait\n10 quit\n",
                                  {}, options);
    EXPECT_EQ(result.exitCode, 0) << result.err;
}

} // namespace
} // namespace eikonal::test

// The window on a virtual screen, driven by recordings: what a person may do ends well, and what is refined is the still
// that `eikonal render` makes.
#include <filesystem>

#include "tests/window/window_fixture.h"

namespace eikonal::test {
namespace {

TEST_F(WindowTest, TheRefinedStillIsTheRendersAndAFullTurnComesBack) {
    // Half a turn for a way of the picture's height.
    const std::string turn =
        "0 cursor 80 60\n1 button left down\n2 cursor 80 61\n3 cursor 200 61\n4 cursor 320 60\n5 button left up\n5 wait\n"
        "5 key f12 down\n5 key f12 up\n5 wait\n6 quit\n";
    expectGood("0 key tab down\n0 key tab up\n0 wait\n" + kSave + turn);
    EXPECT_LT(rmsDifference(still(1), rendered()), kStillTolerance);
    EXPECT_LT(rmsDifference(still(2), still(1)), kStillTolerance);
}

TEST_F(WindowTest, AnotherLightIsBakedAsTheRenderBakesIt) {
    expectGood("0 wait\n0 set light.0.direction=[0.6, -0.8, 0]\n0 wait\n" + kSave + "0 quit\n");
    EXPECT_LT(rmsDifference(still(1), rendered({"--set", "light.0.direction=[0.6, -0.8, 0]"})), kStillTolerance);
    EXPECT_GT(rmsDifference(still(1), rendered()), 5.0 * kStillTolerance) << "the light's direction shows";
}

TEST_F(WindowTest, AnEffectThatIsSwitchedOffIsGone) {
    const std::string effects = "render.effects=[\"refraction\", \"environment\"]";
    expectGood("0 wait\n0 set " + effects + "\n0 wait\n" + kSave + "0 quit\n");
    EXPECT_LT(rmsDifference(still(1), rendered({"--set", effects})), kStillTolerance);
}

TEST_F(WindowTest, BrightnessDoesNotJumpWhenThePictureIsRefined) {
    expectGood("0 key tab down\n0 key tab up\n0 wait\n0 scroll 1\n0 screenshot moving.png\n"
               "1 wait\n1 screenshot still.png\n2 quit\n");
    const double refined = meanOf(folder.file("still.png"));
    // The eye takes two percent for nothing, and a coarse picture has no more than a few hundred pixels to average.
    EXPECT_NEAR(meanOf(folder.file("moving.png")), refined, 0.02 * refined);
}

TEST_F(WindowTest, TakesWhatAPersonMayDo) {
    const std::string other = folder.write("other.toml", kSmallScene + "exposure = 1\n");
    std::string script = "0 size 320 240\n2 cursor 60 120\n3 button left down\n4 cursor 90 100\n5 button left up\n"
                         "6 key shift down\n6 button left down\n7 cursor 70 130\n8 button left up\n8 key shift up\n"
                         "9 button middle down\n10 cursor 60 60\n11 button middle up\n12 scroll 2\n13 scroll -3\n"
                         "14 key w down\n16 key w up\n16 key a down\n18 key a up\n";
    for (const char* key : {"enter", "1", "3", "7", "h", "h", "v", "v", "v", "v", "v", "v", "space", "space", "r", "p", "f2",
                            "f", "f"}) {
        script += std::string("20 key ") + key + " down\n20 key " + key + " up\n";
    }
    script += "21 set camera.fov=50\n22 set object.0.ior=1.3\n23 set render.exposure=1\n"
              "24 set render.effects=[\"refraction\"]\n"
              "25 set render.effects=\"auto\"\n26 drop " + other + "\n27 size 200 150\n28 wait\n29 quit\n";
    const RunResult result = view(script);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("[camera]\nposition = "), std::string::npos) << result.out;
    EXPECT_TRUE(std::filesystem::exists(folder.file("scene_0001.toml")));
}

TEST_F(WindowTest, AClickInThePanelSwitchesAnEffect) {
    // The box before "refraction": the panel is 330 pixels wide, 10 from the right edge, and begins with fixed rows.
    expectGood("0 size 480 360\n2 wait\n2 cursor 157 162\n3 button left down\n4 button left up\n6 cursor 20 300\n6 wait\n"
               "7 key f2 down\n8 quit\n");
    const std::string saved = readText(folder.file("scene_0001.toml"));
    EXPECT_NE(saved.find("effects = [\"absorption\", \"scattering\""), std::string::npos) << saved;
    EXPECT_EQ(saved.find("\"refraction\""), std::string::npos);
}

TEST_F(WindowTest, ASectionWithTheNameOfAnEffectOpens) {
    // The section "environment", and in it the number behind "rotate".
    expectGood("0 size 700 760\n2 wait\n2 cursor 500 553\n3 button left down\n4 button left up\n6 cursor 570 599\n"
               "7 button left down\n8 cursor 590 599\n9 cursor 610 599\n10 button left up\n12 wait\n12 key f2 down\n13 quit\n");
    const std::string saved = readText(folder.file("scene_0001.toml"));
    EXPECT_NE(saved.find("[environment]\nrotate = "), std::string::npos) << saved;
}

TEST_F(WindowTest, KeysAreKeysAfterThePanelsCameBack) {
    expectGood("0 size 700 500\n2 key tab down\n2 key tab up\n4 key tab down\n20 key tab up\n22 key f2 down\n23 quit\n");
    EXPECT_TRUE(std::filesystem::exists(folder.file("scene_0001.toml"))) << "not the text of a number that Tab went to";
}

TEST_F(WindowTest, ADraggedLightIsFollowed) {
    // The beam comes along x: its handle is left of the middle, at 0.45 of the domain's diagonal.
    expectGood("0 key tab down\n0 key tab up\n0 wait\n0 screenshot before.png\n1 set light.0.direction=[0, 0, -1]\n1 wait\n"
               "2 cursor 80 60\n3 button left down\n4 cursor 90 50\n5 cursor 100 40\n6 button left up\n6 wait\n"
               "7 screenshot after.png\n8 quit\n");
    EXPECT_NE(meanOf(folder.file("before.png")), meanOf(folder.file("after.png")));
}

TEST_F(WindowTest, ClosesDuringABake) {
    expectGood("0 set domain.resolution=96\n2 set light.0.direction=[0, 1, 0]\n3 quit\n");
}

TEST_F(WindowTest, ARecordingReplaysToTheSamePicture) {
    const std::string recording = folder.file("recorded.rec");
    const RunResult first = view("0 key tab down\n0 key tab up\n0 scroll 2\n1 cursor 20 100\n2 button left down\n3 cursor 50 90\n4 button left up\n5 wait\n"
                                 "5 key f12 down\n5 wait\n6 quit\n",
                                 {"--record", recording});
    ASSERT_EQ(first.exitCode, 0) << first.err;
    const std::string recorded = readText(recording);
    ASSERT_NE(recorded.find("button left down"), std::string::npos);
    // The picture is saved once it is refined, which takes its own number of frames again.
    const std::size_t quit = recorded.rfind('\n', recorded.size() - 2) + 1;
    const std::string frame = recorded.substr(quit, recorded.find(' ', quit) - quit);
    const RunResult second = view(recorded.substr(0, quit) + frame + " wait\n" + frame + " quit\n");
    ASSERT_EQ(second.exitCode, 0) << second.err;
    EXPECT_LT(rmsDifference(still(2), still(1)), kStillTolerance);
}

TEST(Turntable, BeginsWithTheScenesViewAndHasItsOppositeHalfWay) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    ASSERT_EQ(runEikonal({"-q", "view", scene, "--frames", "2", "--out", folder.file("turn_#.exr")}).exitCode, 0);
    for (const auto& [frame, position] : {std::pair{"0", "[0, 0, 4]"}, std::pair{"1", "[0, 0, -4]"}}) {
        const std::string file = folder.file("render.exr");
        const std::string camera = std::string("camera.position=") + position;
        ASSERT_EQ(runEikonal({"-q", "render", scene, "--set", camera, "-o", file}).exitCode, 0);
        const ChannelImage turned = readChannels(folder.file(std::string("turn_") + frame + ".exr"));
        EXPECT_LT(rmsDifference(turned, readChannels(file)), kStillTolerance) << frame;
    }
}

TEST_F(WindowTest, SaysOnStderrWhatARecordingAskedForInVain) {
    const RunResult result = view("0 set camera.fov=500\n1 set camera.fov=50\n2 quit\n");
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.err.find("warning: --set camera.fov=500: "), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("camera.fov=50:"), std::string::npos) << result.err;
}

TEST_F(WindowTest, SaysWhatIsWrongWithARecordingAndWithoutAScreen) {
    const RunOptions noScreen{.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}};
    const RunResult wrong = runEikonal({"view", scene, "--script", folder.write("script.rec", "0 jump\n")}, noScreen);
    EXPECT_EQ(wrong.exitCode, 3) << "before a window is opened";
    EXPECT_NE(wrong.err.find("script.rec:1: unknown event 'jump'"), std::string::npos) << wrong.err;
    const RunResult blind = runEikonal({"view", scene}, noScreen);
    EXPECT_EQ(blind.exitCode, 4);
    EXPECT_NE(blind.err.find("display"), std::string::npos) << blind.err;
}

} // namespace
} // namespace eikonal::test

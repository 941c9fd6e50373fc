// The command line itself: help, version, wrong usage.

#include <gtest/gtest.h>

#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

const std::vector<std::string> kCommands{"voxelize", "bake", "render", "view", "trace", "info", "bench", "figure"};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST(Usage, HelpListsEveryCommand) {
    const RunResult result = runEikonal({"--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    for (const std::string& command : kCommands) {
        EXPECT_TRUE(contains(result.out, "\n  " + command)) << command;
    }
}

TEST(Usage, HelpOfEachCommandEndsWithAnExample) {
    for (const std::string& command : kCommands) {
        const RunResult result = runEikonal({command, "--help"});
        EXPECT_EQ(result.exitCode, 0) << command;
        const std::size_t example = result.out.rfind("xample");
        ASSERT_NE(example, std::string::npos) << command;
        EXPECT_TRUE(contains(result.out.substr(example), "eikonal " + command)) << command;
    }
}

TEST(Usage, VersionNamesLibrariesAndRenderer) {
    const RunResult result = runEikonal({"--version"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(contains(result.out, "OpenVDB 1")) << result.out;
    EXPECT_TRUE(contains(result.out, "renderer: ")) << result.out;
    EXPECT_FALSE(contains(result.out, "renderer: none")) << result.out;
}

TEST(Usage, VersionNeedsNoDevice) {
    const RunResult result = runEikonal({"--version"}, {.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"}});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(contains(result.out, "renderer: none")) << result.out;
}

TEST(Usage, WrongUsageExitsWith2AndSaysWhy) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const std::vector<std::vector<std::string>> wrong{
        {},
        {"paint"},
        {"bake"},
        {"bake", scene},
        {"bake", scene, "-o", folder.file("out.vdb"), "--paint"},
        {"bake", scene, "-o", folder.file("out.vdb"), "--resolution", "many"},
        {"bake", scene, "-o", folder.file("out.vdb"), "--set", "novalue"},
        {"bake", scene, "-o", folder.file("out.vdb"), "--wavefront", "1"},
        {"bake", scene, "-o", folder.file("out.ply"), "--wavefront", "1,-2"},
        {"bake", scene, "-o", folder.file("out.ply"), "--wavefront", "nan"},
        {"bake", scene, "-o", folder.file("out.ply"), "--wavefront", "1", "--stats", folder.file("out.json")},
        {"render", scene, "-o", folder.file("out.tiff")},
        {"render", scene, "-o", folder.file("out")},
        {"render", scene, "-o", folder.file("out.png"), "--size", "640"},
        {"render", scene, "-o", folder.file("out.png"), "--size", "640x-480"},
        {"view", scene, "--frames", "3"},
        {"view", scene, "--frames", "3", "--out", folder.file("out.png")},
        {"trace", scene, "-o", folder.file("out.csv")},
        {"bake", scene, "-o", folder.file("out.png")},
        {"bake", scene, "-o", scene},
        {"bake", scene, "-o", folder.file("out.vdb"), "--stats", folder.file("out.vdb")},
        {"bake", scene, "-o", folder.file("out.vdb"), "--stats", scene},
        {"bake", scene, "-o", folder.file("out.vdb"), "--frames", "0"},
        {"render", scene, "-o", folder.file("out.png"), "--stats", folder.file("./out.png")},
        {"render", scene, "-o", folder.file("out.png"), "--samples", "0"},
        {"voxelize", folder.file("a.ply"), "-o", folder.file("a.ply")},
        {"info"},
    };
    for (const auto& arguments : wrong) {
        const RunResult result = runEikonal(arguments);
        const std::string shown = testing::PrintToString(arguments);
        EXPECT_EQ(result.exitCode, 2) << shown << result.err;
        EXPECT_EQ(result.err.rfind("error: ", 0), 0u) << shown << result.err;
        EXPECT_LT(result.err.size(), 400u) << shown << result.err;
        EXPECT_EQ(result.out, "") << shown;
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.toml"});
}

TEST(Usage, AWordThatIsNoCommandIsNamed) {
    const RunResult result = runEikonal({"--quiet", "rendr"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_TRUE(contains(result.err, "found 'rendr', did you mean 'render'?")) << result.err;
}

TEST(Usage, WarnsOfLightThatMissesTheDomain) {
    const TemporaryFolder folder;
    const std::string lit = folder.write("lit.toml", kSmallScene);
    const std::string dark = folder.write("dark.toml", "[domain]\nresolution = 8\n");
    const std::string past = folder.write("past.toml", "[domain]\nresolution = 8\n[[light]]\ntype = \"spot\"\nposition = [0, 3, 0]\n"
                                                       "direction = [0, 1, 0]\nangle = 20\n");
    EXPECT_FALSE(contains(runEikonal({"bake", lit, "-o", folder.file("a.vdb")}).err, "warning: "));
    EXPECT_TRUE(contains(runEikonal({"bake", past, "-o", folder.file("c.vdb")}).err, "warning: ")) << "it shines away";
    EXPECT_TRUE(contains(runEikonal({"bake", dark, "-o", folder.file("b.vdb")}).err, "warning: ")) << "no light at all";
}

TEST(Usage, QuietSilencesProgressBeforeAndAfterTheCommand) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    EXPECT_EQ(runEikonal({"--quiet", "bake", scene, "-o", folder.file("a.vdb")}).err, "");
    EXPECT_EQ(runEikonal({"bake", scene, "-o", folder.file("b.vdb"), "--quiet"}).err, "");
    EXPECT_NE(runEikonal({"bake", scene, "-o", folder.file("c.vdb")}).err, "");
}

TEST(Usage, NoColoursOrBarsAwayFromATerminal) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result = runEikonal({"bake", scene, "-o", folder.file("a.vdb")});
    EXPECT_FALSE(contains(result.err, "\x1b"));
    EXPECT_FALSE(contains(result.err, "\r"));
}

} // namespace eikonal::test

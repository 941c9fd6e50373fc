#include "tests/window/window_fixture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <sys/wait.h>

namespace eikonal::test {

const std::string kSave = "0 key f12 down\n0 key f12 up\n0 wait\n";
const std::string kWithoutPanels = "0 key tab down\n0 key tab up\n";

void WindowTest::SetUp() {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "xvfb-run is not installed: the window was not tested (tools/install_dependencies --tests)";
    }
    scene = folder.write("scene.toml", kSmallScene);
}

RunResult WindowTest::view(const std::string& script, const std::vector<std::string>& more, RunOptions options) const {
    const std::string file = folder.write("script.rec", script);
    std::vector<std::string> arguments{"view", scene, "--size", "160x120", "--script", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::vector<std::string> screen{"xvfb-run", "-a", "-s", "-screen 0 1280x800x24"};
    options.launcher.insert(options.launcher.begin(), screen.begin(), screen.end());
    options.workingFolder = folder.path().string();
    return runEikonal(arguments, options);
}

namespace {

void expectGoodEnd(const RunResult& result, const std::string& inVain) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
    if (inVain.empty()) {
        EXPECT_EQ(result.err, "");
    } else {
        EXPECT_EQ(result.err.rfind("warning: ", 0), 0u) << result.err;
        EXPECT_NE(result.err.find(inVain), std::string::npos) << result.err;
        EXPECT_EQ(result.err.find("warning: ", 1), std::string::npos) << "one is enough: " << result.err;
    }
}

} // namespace

void WindowTest::expectGood(const std::string& script, const std::vector<std::string>& more, const std::string& inVain) const {
    expectGoodEnd(view(script, more), inVain);
}

void WindowTest::expectGoodWhileReplacing(const std::vector<Replacement>& replacements, const std::string& script,
                                          const std::vector<std::string>& more, const std::string& inVain) const {
    RunOptions options;
    options.whileRunning = [&](pid_t child) {
        for (const Replacement& replacement : replacements) {
            const auto runs = [&] {
                siginfo_t ended{};
                return ::waitid(P_PID, id_t(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
            };
            while (!std::filesystem::exists(folder / replacement.screenshot) && runs()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            }
            std::filesystem::rename(folder.write("replacement", replacement.text), replacement.file);
        }
    };
    expectGoodEnd(view(script, more, options), inVain);
}

ChannelImage WindowTest::still(int number) const {
    return readChannels(folder.file("eikonal_000" + std::to_string(number) + ".exr"));
}

ChannelImage WindowTest::rendered(const std::vector<std::string>& more) const {
    const std::string file = folder.file("render.exr");
    std::vector<std::string> arguments{"render", scene, "--size", "160x120", "-o", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = runEikonal(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return readChannels(file);
}

double rmsDifference(const ChannelImage& a, const ChannelImage& b) {
    EXPECT_EQ(a.size, b.size);
    double sum = 0.0;
    std::size_t count = 0;
    for (const char* name : {"R", "G", "B"}) {
        const auto& left = a.channels.at(name);
        const auto& right = b.channels.at(name);
        for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) sum += std::pow(left[i] - right[i], 2);
        count += left.size();
    }
    return std::sqrt(sum / double(count));
}

double rmsDifference(const Image& a, const Image& b) {
    EXPECT_EQ(a.size, b.size);
    double sum = 0.0;
    const std::size_t count = std::min(a.pixels.size(), b.pixels.size());
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 difference = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
        sum += glm::dot(difference, difference) / 3.0;
    }
    return std::sqrt(sum / double(count));
}

double meanOf(const std::string& png) {
    const Image image = readImage(png);
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels) sum += pixel.x + pixel.y + pixel.z;
    return sum / double(image.pixels.size());
}

int errorPixels(const std::string& png) {
    const Image image = readImage(png);
    const glm::vec3 text(1.0f, 0.319f, 0.214f);  // 1, 0.6, 0.5 on the display
    return int(std::count_if(image.pixels.begin(), image.pixels.end(),
                             [&](const glm::vec3& pixel) { return glm::distance(pixel, text) < 0.02f; }));
}

} // namespace eikonal::test

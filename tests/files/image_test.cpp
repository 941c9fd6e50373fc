#include "common/image_io.h"

#include <cmath>
#include <limits>

#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

constexpr glm::ivec2 kSize{7, 5};

std::vector<float> ramp(float scale) {
    std::vector<float> values(std::size_t(kSize.x) * std::size_t(kSize.y));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = scale * float(i);
    return values;
}

void writeColours(const std::filesystem::path& path, const std::vector<float>& r, const std::vector<float>& g,
                  const std::vector<float>& b) {
    writeExr(path, kSize, {{"R", &r}, {"G", &g}, {"B", &b}}, {{"Software", "a test"}});
}

TEST(Image, ExrKeepsFloatsAndOrder) {
    const TemporaryFolder folder;
    writeColours(folder / "a.exr", ramp(1.0f), ramp(0.001f), ramp(1e6f));
    const Image image = readImage(folder / "a.exr");
    ASSERT_EQ(image.size, kSize);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const float i = float(y * kSize.x + x);
            EXPECT_EQ(image.at(x, y), glm::vec3(1.0f * i, 0.001f * i, 1e6f * i)) << "stored as 32-bit floats";
        }
}

TEST(Image, ExrKeepsChannelsByName) {
    const TemporaryFolder folder;
    const auto r = ramp(1.0f), depth = ramp(2.0f), steps = ramp(-3.0f);
    writeExr(folder / "a.exr", kSize, {{"R", &r}, {"G", &r}, {"B", &r}, {"steps", &steps}, {"depth.R", &depth}}, {});
    const ChannelImage image = readChannels(folder / "a.exr");
    EXPECT_EQ(image.channels.size(), 5u);
    EXPECT_EQ(image.channels.at("depth.R"), depth);
    EXPECT_EQ(image.channels.at("steps"), steps);
}

TEST(Image, EqualInputsGiveEqualBytes) {
    const TemporaryFolder folder;
    writeColours(folder / "a.exr", ramp(1.0f), ramp(2.0f), ramp(3.0f));
    writeColours(folder / "b.exr", ramp(1.0f), ramp(2.0f), ramp(3.0f));
    EXPECT_EQ(readText(folder / "a.exr"), readText(folder / "b.exr"));
    EXPECT_FALSE(readText(folder / "a.exr").empty());
}

TEST(Image, DisplayValuesAreStoredAsTheyAre) {
    const TemporaryFolder folder;
    std::vector<glm::vec3> pixels(std::size_t(kSize.x * kSize.y), glm::vec3(0.5f, -1.0f, 7.0f));
    writeDisplay(folder / "a.png", kSize, pixels);
    const ChannelImage stored = readChannels(folder / "a.png");
    EXPECT_NEAR(stored.channels.at("R")[0], 128.0f / 255.0f, 1e-6f);  // 127.5 rounds up
    EXPECT_EQ(stored.channels.at("G")[0], 0.0f);
    EXPECT_EQ(stored.channels.at("B")[0], 1.0f);
    // Read as a picture, the sRGB curve comes off: 0.2158 at 128/255.
    EXPECT_NEAR(readImage(folder / "a.png").at(0, 0).r, 0.2158f, 1e-3f);
}

TEST(Image, WritesJpeg) {
    const TemporaryFolder folder;
    const std::vector<glm::vec3> pixels(std::size_t(kSize.x * kSize.y), glm::vec3(0.25f, 0.5f, 0.75f));
    writeDisplay(folder / "a.jpg", kSize, pixels);
    const ChannelImage stored = readChannels(folder / "a.jpg");
    ASSERT_EQ(stored.size, kSize);
    EXPECT_NEAR(stored.channels.at("G")[9], 0.5f, 0.02f);  // lossy; even colour loses a few of 255 steps
}

TEST(Image, RefusesOtherExtensions) {
    const TemporaryFolder folder;
    expectError(ExitCode::kUsage, ".gif", [&] { writeDisplay(folder / "a.gif", kSize, {}); });
    EXPECT_EQ(folder.names().size(), 0u);
}

TEST(Image, NamesThePixelThatIsNotFinite) {
    const TemporaryFolder folder;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.5f}) {
        auto green = ramp(1.0f);
        green[std::size_t(2 * kSize.x + 3)] = bad;
        writeColours(folder / "bad.exr", ramp(1.0f), green, ramp(1.0f));
        expectError(ExitCode::kBadInput, "x = 3, y = 2 (G)", [&] { readImage(folder / "bad.exr"); });
    }
}

TEST(Image, SaysWhatIsMissingOrNoImage) {
    const TemporaryFolder folder;
    expectError(ExitCode::kBadInput, "no such file", [&] { readImage(folder / "none.hdr"); });
    writeText(folder / "text.hdr", "not an image");
    expectError(ExitCode::kBadInput, "text.hdr", [&] { readImage(folder / "text.hdr"); });
    writeText(folder / "text.exr", "");
    expectError(ExitCode::kBadInput, "text.exr", [&] { readImage(folder / "text.exr"); });
}

TEST(Image, ReportsAFullDisk) {
    const TemporaryFolder folder;
    if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "there is no /dev/full";
    const std::vector<glm::vec3> pixels(std::size_t(kSize.x * kSize.y));
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    std::filesystem::create_symlink("/dev/full", folder / "full.exr");
    expectError(ExitCode::kFailure, "No space", [&] { writeDisplay(folder / "full.png", kSize, pixels); });
    expectError(ExitCode::kFailure, "No space", [&] { writeColours(folder / "full.exr", ramp(1), ramp(1), ramp(1)); });
}

} // namespace
} // namespace eikonal::test

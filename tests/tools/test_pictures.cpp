// The gallery of the README is what the program still renders: each shipped scene, at a quarter of the gallery's size.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/image_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

constexpr int kReduction = 4;

/// Mean over squares of kReduction pixels.
Image reduced(const Image& image) {
    Image result{image.size / kReduction, {}};
    for (int y = 0; y < result.size.y; ++y) {
        for (int x = 0; x < result.size.x; ++x) {
            glm::vec3 sum(0.0f);
            for (int i = 0; i < kReduction * kReduction; ++i) {
                sum += image.at(kReduction * x + i % kReduction, kReduction * y + i / kReduction);
            }
            result.pixels.push_back(sum / float(kReduction * kReduction));
        }
    }
    return result;
}

/// Differences by pixel in the square root of linear values, near to how they look; the largest band's.
std::vector<double> differences(const Image& a, const Image& b) {
    std::vector<double> result;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3 difference = glm::abs(glm::sqrt(a.pixels[i]) - glm::sqrt(b.pixels[i]));
        result.push_back(std::max({difference.r, difference.g, difference.b}));
    }
    return result;
}

class Picture : public testing::TestWithParam<std::string> {};

} // namespace

TEST_P(Picture, LooksLikeTheGallery) {
    const Image gallery = reduced(readImage(std::string(EIKONAL_GALLERY) + "/" + GetParam() + ".png"));
    const TemporaryFolder folder;
    std::vector<std::string> arguments = shippedScene(GetParam(), folder);
    arguments.insert(arguments.begin(), "render");
    const std::string size = std::to_string(gallery.size.x) + "x" + std::to_string(gallery.size.y);
    // A pixel here is sixteen of the gallery's, each of two samples and more.
    arguments.insert(arguments.end(), {"--size", size, "--samples", "8", "-o", folder.file("picture.png")});
    const RunResult result = runEikonal(arguments);
    ASSERT_EQ(result.exitCode, 0) << result.err;

    const Image picture = readImage(folder.file("picture.png"));
    ASSERT_EQ(picture.size, gallery.size);
    std::vector<double> difference = differences(picture, gallery);
    double mean = 0.0;
    for (const double value : difference) {
        mean += value / double(difference.size());
    }
    std::sort(difference.begin(), difference.end());
    RecordProperty("mean_difference", std::to_string(mean));
    EXPECT_LT(mean, 0.01);
    EXPECT_LT(difference[difference.size() * 95 / 100], 0.05);
}

INSTANTIATE_TEST_SUITE_P(Gallery, Picture,
                         testing::Values("glass_sphere", "amber_figure", "amber_inclusions", "wine_glass", "luneburg",
                                         "fog_point_light", "glass_plate", "prism", "rainbow_sphere", "layered_cube", "nine_spheres",
                                         "logo_block"),
                         [](const auto& picture) { return picture.param; });

} // namespace eikonal::test

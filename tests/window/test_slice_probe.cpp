// The numbers under the pointer are those of the grid that a slice cuts.
#include <gtest/gtest.h>

#include "tests/support/synthetic_fields.h"
#include "viewer/window/slice_probe.h"

namespace eikonal::window {
namespace {

const glm::dvec2 kMiddle(0.5, 0.5);

Camera camera() { return test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 32).camera; }

std::vector<float> valuesAt(const viewer::LookSettings& look, const glm::dvec2& at, const Fields& fields, const BakedLight* light) {
    const auto probe = probeSlice(look, camera(), at, 1.0, fields, light);
    EXPECT_TRUE(probe);
    return probe ? probe->values : std::vector<float>{};
}

TEST(SliceProbe, TellsTheIndexOfTheVoxel) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 0.05);
    const viewer::LookSettings look{.look = viewer::Look::kIndex};
    constexpr float kRounding = 1e-6f;
    const auto middle = valuesAt(look, kMiddle, fields, nullptr);
    ASSERT_EQ(middle.size(), 1u);
    EXPECT_NEAR(middle[0], 1.5f, kRounding);
    const auto corner = valuesAt(look, {0.2, 0.2}, fields, nullptr);  // half the height is 4 tan 20° = 1.46
    ASSERT_EQ(corner.size(), 1u);
    EXPECT_NEAR(corner[0], 1.0f, kRounding) << "beside the ball";
    EXPECT_TRUE(valuesAt(look, {0.05, 0.5}, fields, nullptr).empty()) << "beside the domain";
}

TEST(SliceProbe, TellsTheLightOfTheVoxelOnTheSlice) {
    const Fields fields = test::uniformFields(test::cube(16, 1.0));
    BakedLight light;
    light.lattice = test::cube(4, 1.0);  // coarser, as a first bake is
    light.irradiance = {light.lattice.size, glm::vec3(0.0f)};
    light.lightDirection = {light.lattice.size, glm::vec3(0.0f, -1.0f, 0.0f)};
    for (int k = 0; k < 4; ++k) light.irradiance.at(2, 1, k) = {float(k), 5.0f, 6.0f};
    const glm::dvec2 rightBelow(0.55, 0.55);
    viewer::LookSettings look{.look = viewer::Look::kIrradiance, .slicePosition = 0.75};
    EXPECT_EQ(valuesAt(look, rightBelow, fields, &light), (std::vector<float>{3.0f, 5.0f, 6.0f}));
    look.slicePosition = -0.75;
    EXPECT_EQ(valuesAt(look, rightBelow, fields, &light), (std::vector<float>{0.0f, 5.0f, 6.0f}));
    EXPECT_TRUE(valuesAt(look, rightBelow, fields, nullptr).empty()) << "no light yet";
    look.look = viewer::Look::kDirection;
    EXPECT_EQ(valuesAt(look, rightBelow, fields, &light), (std::vector<float>{0.0f, -1.0f, 0.0f}));
}

TEST(SliceProbe, SaysNothingOfOtherPictures) {
    const Fields fields = test::uniformFields(test::cube(16, 1.0));
    EXPECT_FALSE(probeSlice({.look = viewer::Look::kSteps}, camera(), kMiddle, 1.0, fields, nullptr));
}

} // namespace
} // namespace eikonal::window

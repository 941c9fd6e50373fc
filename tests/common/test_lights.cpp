// Lights of a scene file, and where those that move are.
#include <gtest/gtest.h>

#include <numbers>

#include "common/light_motion.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string kAllLights = R"toml(
[[light]]
type = "spot"
position = [1, 2, 3]
direction = [0, 0, 2]
power = [1, 2, 3]
angle = 25
blend = 0.5
[[light.keyframe]]
frame = 0
position = [0, 0, 0]
[[light.keyframe]]
frame = 10.5
position = [1, 2, 3]
direction = [0, 3, 0]
[[light]]
type = "rectangle"
direction = [0, 0, -1]
up = [0, 2, 0]
size = [2, 0.5]
samples = 9
[[light]]
[[light.keyframe]]
frame = 3
direction = [1, 2, 3]
[[light]]
type = "point"
)toml";

TEST(Lights, AreReadWithTheirKeys) {
    const Scene scene = sceneOf(kAllLights);
    const auto& spot = std::get<SpotLight>(scene.lights.at(0));
    EXPECT_EQ(spot.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(spot.direction, glm::dvec3(0.0, 0.0, 1.0));  // normalised
    EXPECT_DOUBLE_EQ(spot.angle, 25.0);
    EXPECT_DOUBLE_EQ(spot.blend, 0.5);
    ASSERT_EQ(spot.keyframes.size(), 2u);
    EXPECT_FALSE(spot.keyframes[0].direction);
    EXPECT_DOUBLE_EQ(spot.keyframes[1].frame, 10.5);
    EXPECT_EQ(spot.keyframes[1].direction, glm::dvec3(0.0, 1.0, 0.0));
    const auto& rectangle = std::get<RectangleLight>(scene.lights.at(1));
    EXPECT_EQ(rectangle.size, glm::dvec2(2.0, 0.5));
    EXPECT_EQ(rectangle.samples, 9);
    EXPECT_EQ(rectangle.up, glm::dvec3(0.0, 1.0, 0.0));
}

TEST(Lights, KeepTheirParametersOverAWrittenScene) {
    const std::string once = resolvedToml(sceneOf(kAllLights));
    EXPECT_EQ(once, resolvedToml(sceneOf(once)));
    EXPECT_TRUE(contains(once, "keyframe = [{ frame = ")) << once;
    EXPECT_EQ(std::get<SpotLight>(sceneOf(once).lights[0]).keyframes.size(), 2u);
}

TEST(Lights, CanBeSetOnTheCommandLine) {
    const Scene scene = sceneOf(kAllLights, {"light.0.angle=30", "light.0.keyframe.1.frame=12", "environment.lights=8"});
    EXPECT_DOUBLE_EQ(std::get<SpotLight>(scene.lights[0]).angle, 30.0);
    EXPECT_DOUBLE_EQ(std::get<SpotLight>(scene.lights[0]).keyframes[1].frame, 12.0);
    EXPECT_EQ(scene.environment.lights, 8);
}

TEST(Lights, WrongOnesSayWhereAndWhatIsRight) {
    EXPECT_TRUE(contains(errorOf("[[light]]\ntype = \"spt\"\n"), "did you mean 'spot'?"));
    EXPECT_TRUE(contains(errorOf("[[light]]\ntype = \"spot\"\nangel = 3\n"), "did you mean 'angle'?"));
    EXPECT_TRUE(contains(errorOf("[[light]]\ntype = \"point\"\ndirection = [1, 0, 0]\n"), "unknown key 'direction'"));
    EXPECT_TRUE(contains(errorOf("[environment]\nlight = 3\n"), "did you mean 'lights'?"));
    for (const char* bad : {"type = \"spot\"\nangle = 0\n", "type = \"spot\"\nangle = 361\n",
                            "type = \"spot\"\nblend = 1.5\n", "type = \"rectangle\"\nsize = [1, 0]\n",
                            "type = \"rectangle\"\nsamples = 0\n", "type = \"rectangle\"\nup = [0, 0, 0]\n"})
        EXPECT_TRUE(contains(errorOf(std::string("[[light]]\n") + bad), "s.toml:3:")) << errorOf(std::string("[[light]]\n") + bad);
}

TEST(Lights, WrongKeyframesSayWhereAndWhatIsRight) {
    const std::string point = "[[light]]\ntype = \"point\"\n[[light.keyframe]]\n";
    EXPECT_TRUE(contains(errorOf(point + "frame = 0\npositoin = [0, 0, 0]\n"),
                         "s.toml:5:12: unknown key 'positoin' in light.0.keyframe.0, did you mean 'position'?"))
        << errorOf(point + "frame = 0\npositoin = [0, 0, 0]\n");
    EXPECT_TRUE(contains(errorOf(point + "frame = 0\ndirection = [1, 0, 0]\n"), "unknown key 'direction'"));
    EXPECT_TRUE(contains(errorOf(point + "position = [0, 0, 0]\n"), "a table with a key 'frame'"));
    EXPECT_TRUE(contains(errorOf(point + "frame = 2\n[[light.keyframe]]\nframe = 2\n"), "ascending order, found 2 after 2"));
    EXPECT_TRUE(contains(errorOf("[[light]]\nkeyframe = 3\n"), "[[light.keyframe]]"));
    EXPECT_TRUE(contains(errorOf("[[light]]\n[[light.keyframe]]\nframe = 0\ndirection = [1, 0, 0]\n"
                                 "[[light.keyframe]]\nframe = 1\ndirection = [-1, 0, 0]\n"),
                         "less than half a turn apart"));
}

TEST(LightMotion, IsLinearBetweenKeyframesAndHeldOutside) {
    PointLight light{{9.0, 9.0, 9.0}, glm::dvec3(1.0), {}};
    light.keyframes = {{.frame = 2.0, .position = glm::dvec3(0.0, 1.0, 0.0)},
                       {.frame = 6.0, .position = glm::dvec3(4.0, 1.0, -2.0)}};
    const auto positionAt = [&](double frame) { return std::get<PointLight>(lightAt(light, frame)).position; };
    EXPECT_EQ(positionAt(-5.0), glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(positionAt(2.0), glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(positionAt(3.0), glm::dvec3(1.0, 1.0, -0.5));
    EXPECT_EQ(positionAt(6.0), glm::dvec3(4.0, 1.0, -2.0));
    EXPECT_EQ(positionAt(7.0), glm::dvec3(4.0, 1.0, -2.0));
    EXPECT_TRUE(keyframesOf(lightAt(light, 3.0)).empty());
}

TEST(LightMotion, TurnsAtEqualAngles) {
    DirectionalLight light;
    light.keyframes = {{.frame = 0.0, .direction = glm::dvec3(1.0, 0.0, 0.0)},
                       {.frame = 3.0, .direction = glm::dvec3(0.0, 0.0, 1.0)}};
    for (int frame = 0; frame <= 3; ++frame) {
        const double angle = frame * std::numbers::pi / 6.0;
        const glm::dvec3 direction = std::get<DirectionalLight>(lightAt(light, frame)).direction;
        EXPECT_LT(glm::distance(direction, glm::dvec3(std::cos(angle), 0.0, std::sin(angle))), 1e-15);
    }
    // a turn too small for its sine
    light.keyframes[1].direction = glm::normalize(glm::dvec3(1.0, 1e-9, 0.0));
    EXPECT_NEAR(std::get<DirectionalLight>(lightAt(light, 1.5)).direction.y, 0.5e-9, 1e-17);
}

TEST(LightMotion, EachMemberHasItsOwnKeyframes) {
    SpotLight light;
    light.keyframes = {{.frame = 0.0, .position = glm::dvec3(0.0)},
                       {.frame = 1.0, .direction = glm::dvec3(1.0, 0.0, 0.0)},
                       {.frame = 2.0, .position = glm::dvec3(2.0)}};
    const auto placed = std::get<SpotLight>(lightAt(light, 1.0));
    EXPECT_EQ(placed.position, glm::dvec3(1.0)) << "the keyframe without a position does not stop it";
    EXPECT_EQ(std::get<SpotLight>(lightAt(light, 9.0)).direction, glm::dvec3(1.0, 0.0, 0.0));
    SpotLight still;
    still.keyframes = {{.frame = 0.0, .position = glm::dvec3(0.0)}};
    EXPECT_EQ(std::get<SpotLight>(lightAt(still, 5.0)).direction, SpotLight{}.direction);
}

} // namespace
} // namespace eikonal

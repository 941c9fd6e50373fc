// A light's handle is where the pointer takes it.
#include <gtest/gtest.h>

#include "viewer/window/light_handle.h"
#include "viewer/window/orbit.h"

namespace eikonal::window {
namespace {

constexpr double kAspect = 16.0 / 9.0;
constexpr double kRounding = 1e-9;

const HandleRoom kWhole{.aspect = kAspect};

const Lattice kDomain{{-1.0, -1.0, -1.0}, 0.1, {20, 20, 20}};

Camera camera() {
    Camera camera;
    camera.position = {1.0, 0.5, 5.0};
    return camera;
}

TEST(LightHandle, APositionFollowsThePointerAtItsDistance) {
    const Light light = PointLight{.position = {0.3, 0.9, -0.2}, .power = glm::dvec3(1.0), .keyframes = {}};
    const Light moved = draggedTo(light, kDomain, camera(), {0.7, 0.4}, kAspect);
    const Projected at = projected(camera(), handlePosition(moved, kDomain), kAspect);
    EXPECT_NEAR(at.at.x, 0.7, kRounding);
    EXPECT_NEAR(at.at.y, 0.4, kRounding);
    EXPECT_NEAR(at.depth, projected(camera(), handlePosition(light, kDomain), kAspect).depth, kRounding);
}

TEST(LightHandle, ABeamComesFromUnderThePointer) {
    const Light moved = draggedTo(DirectionalLight{}, kDomain, camera(), {0.55, 0.45}, kAspect);
    EXPECT_NEAR(glm::length(std::get<DirectionalLight>(moved).direction), 1.0, kRounding);
    const Projected at = projected(camera(), handlePosition(moved, kDomain), kAspect);
    EXPECT_NEAR(at.at.x, 0.55, kRounding);
    EXPECT_NEAR(at.at.y, 0.45, kRounding);
}

TEST(LightHandle, BeyondTheSphereItStaysOnItsOutline) {
    const Light moved = draggedTo(DirectionalLight{}, kDomain, camera(), {0.99, 0.5}, kAspect);
    const glm::dvec3 handle = handlePosition(moved, kDomain);
    // Where the ray passes the sphere nearest, the sphere's normal is across the ray.
    const glm::dvec3 ray = glm::normalize(rayThrough(camera(), {0.99, 0.5}, kAspect));
    EXPECT_NEAR(glm::dot(glm::normalize(handle), ray), 0.0, kRounding);
}

TEST(LightHandle, TheNearestOneIsTaken) {
    Scene scene;
    scene.lights = {PointLight{.position = {0.0, 0.0, 0.0}, .power = glm::dvec3(1.0), .keyframes = {}},
                    PointLight{.position = {0.5, 0.0, 0.0}, .power = glm::dvec3(1.0), .keyframes = {}}};
    const auto at = handleOnScreen(scene.lights[1], kDomain, camera(), kWhole);
    ASSERT_TRUE(at);
    EXPECT_EQ(handleUnder(scene, kDomain, camera(), *at, kWhole, 0.04), 1u);
    EXPECT_EQ(handleUnder(scene, kDomain, camera(), *at + glm::dvec2(0.0, 0.3), kWhole, 0.04), std::nullopt);
}

TEST(LightHandle, OneOutOfViewWaitsAtTheEdge) {
    const Light above = PointLight{.position = {0.0, 40.0, 0.0}, .power = glm::dvec3(1.0), .keyframes = {}};
    const auto at = handleOnScreen(above, kDomain, camera(), kWhole);
    ASSERT_TRUE(at);
    EXPECT_GT(at->y, 0.0);
    EXPECT_LT(at->y, 0.1);
    const Light behind = PointLight{.position = {0.0, 0.0, 40.0}, .power = glm::dvec3(1.0), .keyframes = {}};
    EXPECT_FALSE(handleOnScreen(behind, kDomain, camera(), kWhole));
}

TEST(LightHandle, OneBehindThePanelWaitsAtItsEdge) {
    HandleRoom room = kWhole;
    room.highest.x = 0.7;
    const Light light = PointLight{.position = {2.2, 0.4, 0.0}, .power = glm::dvec3(1.0), .keyframes = {}};
    const auto free = handleOnScreen(light, kDomain, camera(), kWhole);
    ASSERT_TRUE(free);
    ASSERT_GT(free->x, 0.71);
    EXPECT_EQ(handleOnScreen(light, kDomain, camera(), room), glm::dvec2(0.7, free->y));
}

TEST(LightHandle, OneBehindTheNumbersWaitsBesideThem) {
    const Light light = PointLight{.position = {0.0, 0.5, 0.0}, .power = glm::dvec3(1.0), .keyframes = {}};
    const auto free = handleOnScreen(light, kDomain, camera(), kWhole);
    ASSERT_TRUE(free);
    HandleRoom room = kWhole;
    room.numbers = *free + glm::dvec2(0.2, 0.02);
    EXPECT_EQ(handleOnScreen(light, kDomain, camera(), room), glm::dvec2(free->x, room.numbers.y)) << "below is nearer";
    room.numbers = *free + glm::dvec2(0.02, 0.2);
    EXPECT_EQ(handleOnScreen(light, kDomain, camera(), room), glm::dvec2(room.numbers.x, free->y)) << "the right is nearer";
    room.highest.x = room.numbers.x;
    EXPECT_EQ(handleOnScreen(light, kDomain, camera(), room), glm::dvec2(free->x, room.numbers.y)) << "the panel is there";
    room.numbers = *free - 0.02;
    EXPECT_EQ(handleOnScreen(light, kDomain, camera(), room), free);
    EXPECT_EQ(handleUnder({.lights = {light}}, kDomain, camera(), *free, room, 0.01), 0u) << "drawn and taken at the same place";
}

} // namespace
} // namespace eikonal::window

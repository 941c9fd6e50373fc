// What is held decides what the pointer's way means.
#include <gtest/gtest.h>

#include "viewer/window/controls.h"

namespace eikonal::window {
namespace {

constexpr double kHeight = 500.0;  // pixels

Event button(const char* name, bool down) { return {.kind = EventKind::kButton, .name = name, .down = down}; }
Event key(const char* name, bool down) { return {.kind = EventKind::kKey, .name = name, .down = down}; }

Camera afterDrag(Controls& controls, const Camera& camera, const glm::dvec2& way) {
    controls.moveTo(controls.pointer() + way);
    return controls.dragged(camera, kHeight);
}

TEST(Controls, LeftOrbitsMiddleAndShiftLeftPan) {
    const Camera camera;
    Controls controls;
    controls.press(button("left", true), std::nullopt);
    EXPECT_EQ(afterDrag(controls, camera, {50.0, 20.0}).lookAt, camera.lookAt);
    controls.press(button("left", false), std::nullopt);
    EXPECT_EQ(afterDrag(controls, camera, {50.0, 20.0}).position, camera.position) << "nothing is held";
    controls.press(button("middle", true), std::nullopt);
    const Camera panned = afterDrag(controls, camera, {50.0, 20.0});
    EXPECT_NE(panned.lookAt, camera.lookAt);
    controls.press(button("middle", false), std::nullopt);
    controls.key(key("shift", true));
    controls.press(button("left", true), std::nullopt);
    EXPECT_EQ(afterDrag(controls, camera, {50.0, 20.0}).lookAt, panned.lookAt);
}

TEST(Controls, ADragToTheRightTurnsTheSceneToTheRight) {
    Controls controls;
    controls.press(button("left", true), std::nullopt);
    const Camera turned = afterDrag(controls, Camera{}, {kHeight / 4.0, 0.0});
    const glm::dvec3 front(0.0, 0.0, 1.0);  // a point towards the camera
    EXPECT_GT(projected(turned, front, 1.0).at.x, projected(Camera{}, front, 1.0).at.x);
}

TEST(Controls, TheWayCountsOnce) {
    Controls controls;
    controls.press(button("left", true), std::nullopt);
    const Camera once = afterDrag(controls, Camera{}, {40.0, 0.0});
    EXPECT_EQ(controls.dragged(once, kHeight).position, once.position);
}

TEST(Controls, ALightUnderThePointerIsDragged) {
    Controls controls;
    controls.press(button("left", true), 2);
    EXPECT_EQ(controls.drag(), Controls::Drag::kLight);
    EXPECT_EQ(controls.light(), 2u);
    EXPECT_EQ(afterDrag(controls, Camera{}, {40.0, 0.0}).position, Camera{}.position);
    EXPECT_FALSE(controls.hasMoved());
    controls.moveTo({7.0, 7.0});
    EXPECT_TRUE(controls.hasMoved());
}

TEST(Controls, HeldKeysFlyAndOppositeOnesCancel) {
    Controls controls;
    EXPECT_FALSE(controls.flown(Camera{}, 0.1));
    controls.key(key("w", true));
    const auto forward = controls.flown(Camera{}, 0.1);
    ASSERT_TRUE(forward);
    EXPECT_LT(forward->position.z, Camera{}.position.z);
    controls.key(key("s", true));
    EXPECT_FALSE(controls.flown(Camera{}, 0.1));
}

} // namespace
} // namespace eikonal::window

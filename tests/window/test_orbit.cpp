// Camera moves are rigid, and undo each other.
#include <gtest/gtest.h>

#include "viewer/window/orbit.h"

namespace eikonal::window {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRounding = 1e-12;  // of coordinates of order 1 after a few hundred operations

Camera tilted() {
    Camera camera;
    camera.position = {1.0, 2.0, 3.0};
    camera.lookAt = {0.2, -0.1, 0.3};
    camera.up = {0.1, 1.0, -0.2};
    return camera;
}

double distance(const Camera& camera) { return glm::length(camera.position - camera.lookAt); }

void expectSame(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Orbit, AFullTurnInStepsComesBack) {
    Camera camera = tilted();
    for (int i = 0; i < 360; ++i) camera = orbited(camera, {2.0 * kPi / 360.0, 0.0});
    expectSame(camera.position, tilted().position, 360 * kRounding);
}

TEST(Orbit, KeepsTargetAndDistanceAndStopsShortOfThePoles) {
    Camera camera = tilted();
    const glm::dvec3 up = glm::normalize(camera.up);
    for (const double way : {0.3, 5.0, -9.0}) {
        camera = orbited(camera, {0.4, way});
        expectSame(camera.lookAt, tilted().lookAt, kRounding);
        EXPECT_NEAR(distance(camera), distance(tilted()), kRounding);
        EXPECT_LT(std::abs(glm::dot(glm::normalize(camera.position - camera.lookAt), up)), 1.0 - 1e-5) << "at a pole";
    }
    EXPECT_LT(glm::dot(camera.position - camera.lookAt, up), 0.0) << "a long way down ends below";
}

TEST(Orbit, PannedPointsStayUnderThePointer) {
    const Camera camera = tilted();
    const double aspect = 1.5;
    const Projected before = projected(camera, camera.lookAt, aspect);
    const Projected after = projected(panned(camera, {0.2, -0.1}), camera.lookAt, aspect);
    EXPECT_NEAR(after.at.x - before.at.x, 0.2 / aspect, kRounding);
    EXPECT_NEAR(after.at.y - before.at.y, -0.1, kRounding);
}

TEST(Orbit, WheelAndFlightKeepTheDirection) {
    const Camera camera = tilted();
    const Camera near = dollied(dollied(camera, 3.0), -3.0);
    expectSame(near.position, camera.position, 10 * kRounding);
    EXPECT_NEAR(distance(dollied(camera, 1.0)), 0.9 * distance(camera), kRounding);
    const Camera flight = flown(camera, {0.0, 0.0, 0.5});
    EXPECT_NEAR(distance(flight), distance(camera), kRounding);
    expectSame(flight.position - camera.position, 0.5 * (camera.lookAt - camera.position), kRounding);
}

TEST(Orbit, FramingShowsEveryCornerOfTheBox) {
    const Lattice box{{-1.0, 0.0, 2.0}, 0.1, {30, 10, 20}};
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const Camera camera = framing(tilted(), box, aspect);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 share(corner & 1, (corner >> 1) & 1, corner >> 2);
            const Projected at = projected(camera, box.min + share * box.extent(), aspect);
            EXPECT_GT(at.depth, 0.0);
            EXPECT_TRUE(at.at.x > 0.0 && at.at.x < 1.0 && at.at.y > 0.0 && at.at.y < 1.0) << at.at.x << ' ' << at.at.y;
        }
    }
}

TEST(Orbit, AxisViewsLookAlongTheirAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        const Camera camera = alongAxis(tilted(), axis);
        const glm::dvec3 offset = camera.position - camera.lookAt;
        EXPECT_NEAR(offset[axis], distance(tilted()), kRounding);
        EXPECT_GT(glm::length(glm::cross(offset, camera.up)), 0.1) << "the up vector lies in the view";
    }
}

TEST(Orbit, RaysGoThroughWhereTheirPointsAppear) {
    const glm::dvec2 at(0.3, 0.8);
    const Camera camera = tilted();
    const Projected seen = projected(camera, camera.position + 2.5 * rayThrough(camera, at, 1.7), 1.7);
    EXPECT_NEAR(seen.at.x, at.x, kRounding);
    EXPECT_NEAR(seen.at.y, at.y, kRounding);
    EXPECT_NEAR(seen.depth, 2.5, kRounding);
}

} // namespace
} // namespace eikonal::window

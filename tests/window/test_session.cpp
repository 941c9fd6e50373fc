// The picture while other light is on its way: what it is worth to work on.
#include <chrono>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/synthetic_fields.h"
#include "viewer/window/session.h"

namespace eikonal::window {
namespace {

/// A ball without light, of which a frame of a microsecond shows a coarse picture first.
std::unique_ptr<Session> sessionOf(const Scene& scene, const Fields& fields) {
    auto session = std::make_unique<Session>(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr, 1e-6);
    session->resize({48, 32});
    session->advance(NewLight::kNone);
    return session;
}

TEST(Session, LeavesThePictureCoarseWhereLightIsComingSoon) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 0.2);
    const Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 32);
    const auto session = sessionOf(scene, fields);
    ASSERT_FALSE(session->shown().fine);
    EXPECT_FALSE(session->hasWork(NewLight::kSoon));
    EXPECT_TRUE(session->hasWork(NewLight::kLater));
    EXPECT_TRUE(session->hasWork(NewLight::kNone));
}

TEST(Session, TakesOneSampleOfEveryPixelWhereLightIsComingLater) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 0.2);
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 32);
    scene.render.samples = 4;
    const auto session = sessionOf(scene, fields);
    for (int frame = 0; frame < 100 && session->hasWork(NewLight::kLater); ++frame) session->advance(NewLight::kLater);
    EXPECT_FALSE(session->hasWork(NewLight::kLater));
    EXPECT_TRUE(session->shown().fine);
    EXPECT_EQ(session->samples(), 1);
    EXPECT_FALSE(session->isRefined());
    EXPECT_TRUE(session->hasWork(NewLight::kNone));
}

TEST(Session, WhatARayTakesIsTheMeanOverThePicture) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 0.2);
    const Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 32);
    const auto session = sessionOf(scene, fields);
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < 100 && !session->isRefined(); ++frame) session->advance(NewLight::kNone);
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_TRUE(session->isRefined());
    EXPECT_GT(session->secondsPerRay(), 0.0);
    EXPECT_LE(session->secondsPerRay() * 48.0 * 32.0, took) << "of all that was done, the part that was for fine rays";
}

} // namespace
} // namespace eikonal::window

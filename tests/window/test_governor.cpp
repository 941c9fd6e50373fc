// The frame's budget: what it can afford follows from what rays have cost.
#include <gtest/gtest.h>

#include "viewer/window/effect_costs.h"
#include "viewer/window/governor.h"

namespace eikonal::window {
namespace {

constexpr glm::ivec2 kScreen{960, 540};

/// One that has seen nothing but fine rays of that cost.
Governor accustomedTo(double secondsPerRay, double frameSeconds = 0.033) {
    Governor governor(frameSeconds, 0.5);
    for (int i = 0; i < 100; ++i) governor.measured(1000, true, 1000 * secondsPerRay);
    return governor;
}

double seconds(const Detail& detail, double secondsPerRay) {
    return detail.size.x * detail.size.y * secondsPerRay * (detail.fine ? 1.0 : 0.5);
}

TEST(Governor, FitsMovingPicturesIntoAFrame) {
    for (const double cost : {1e-9, 1e-7, 1e-6, 5e-6}) {
        const Detail detail = accustomedTo(cost).moving(kScreen);
        // Three frames for a third of the width and less, with a little for the mean of what was measured.
        EXPECT_LE(seconds(detail, cost), detail.size.x > kScreen.x / 3 ? 0.034 : 0.102) << cost;
        EXPECT_NEAR(double(detail.size.x) / detail.size.y, 16.0 / 9.0, 0.1) << "keeps the shape";
    }
}

TEST(Governor, MakesTheWholePictureAtOnceWhereItCan) {
    EXPECT_EQ(accustomedTo(1e-9).moving(kScreen), (Detail{kScreen, true}));
}

TEST(Governor, ShowsAThirdOfTheWidthRatherThanKeepTheFrame) {
    EXPECT_EQ(accustomedTo(3e-6).moving(kScreen).size, kScreen / 3) << "0.086 s: three frames, not one";
}

TEST(Governor, UsesMostOfTheFrame) {
    // The next finer picture has at most 2.25 times the pixels.
    for (const double cost : {3e-7, 1e-6, 3e-6}) EXPECT_GT(seconds(accustomedTo(cost).moving(kScreen), cost), 0.033 / 2.3);
}

TEST(Governor, ShowsSomethingHoweverSlow) {
    const Detail detail = accustomedTo(1.0).moving({3, 2});
    EXPECT_EQ(detail.size, glm::ivec2(1));
    EXPECT_GE(accustomedTo(1.0).raysWithin(0.0, true), 1u) << "every frame gets on";
}

TEST(Governor, CoarseRaysCostTheirShare) {
    Governor governor(0.033, 0.5);
    for (int i = 0; i < 100; ++i) governor.measured(1000, false, 1000 * 0.5e-6);
    EXPECT_NEAR(governor.secondsPerRay(true), 1e-6, 1e-9);
    EXPECT_NEAR(double(governor.raysWithin(0.01, false)), 2.0 * double(governor.raysWithin(0.01, true)), 2.0);
}

TEST(Governor, RefinementEndsAtFullDetail) {
    Detail detail{{60, 34}, false};
    int steps = 0;
    while (!(detail == Detail{kScreen, true})) {
        const Detail next = Governor::refined(detail, kScreen);
        ASSERT_FALSE(next == detail);
        ASSERT_LE(detail.size.x, next.size.x);
        detail = next;
        ++steps;
    }
    EXPECT_LE(steps, 3);
}

EffectSet withSwitches(bool scattering) {
    EffectSet set;
    for (int i = 0; i <= int(Effect::kEnvironment); ++i) set.decisions.push_back({Effect(i), true, "", {}});
    set.decisions[std::size_t(Effect::kScattering)].on = scattering;
    return set;
}

TEST(EffectCosts, AreTheDifferenceOfBothWays) {
    EffectCosts costs;
    costs.measured(withSwitches(true), 5e-6);
    EXPECT_FALSE(costs.cost(withSwitches(true), Effect::kScattering)) << "not seen without it";
    costs.measured(withSwitches(false), 2e-6);
    EXPECT_DOUBLE_EQ(*costs.cost(withSwitches(true), Effect::kScattering), 3e-6);
    EXPECT_DOUBLE_EQ(*costs.cost(withSwitches(false), Effect::kScattering), 3e-6);
    EXPECT_FALSE(costs.cost(withSwitches(true), Effect::kRefraction));
}

} // namespace
} // namespace eikonal::window

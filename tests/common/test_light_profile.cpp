// Angular profiles of lights (shaders/physics/profile.glsl) against their definition.
#include <gtest/gtest.h>

#include <numbers>

#include "common/physics.h"

namespace eikonal {
namespace {

constexpr double kPi = std::numbers::pi;

/// Unit vector at an angle to +Z.
glm::dvec3 at(double angle) { return {std::sin(angle), 0.0, std::cos(angle)}; }

/// Mean over the sphere of a function of the angle to the axis, by the midpoint rule in its cosine.
template <class Share>
double sphereMean(const Share& share) {
    const int cells = 200000;
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) {
        sum += share(std::acos(-1.0 + 2.0 * (i + 0.5) / cells));
    }
    return sum / cells;
}

TEST(LightProfile, OfAConeIsOneInsideZeroOutsideAndFallsBetween) {
    const glm::dvec3 axis(0.0, 0.0, 1.0);
    const double inner = f64::versineOfAngle(0.4), outer = f64::versineOfAngle(0.5);
    EXPECT_EQ(f64::coneShare(at(0.0), axis, inner, outer), 1.0);
    EXPECT_EQ(f64::coneShare(at(0.399), axis, inner, outer), 1.0);
    EXPECT_EQ(f64::coneShare(at(0.501), axis, inner, outer), 0.0);
    EXPECT_EQ(f64::coneShare(-axis, axis, inner, outer), 0.0);
    double last = 1.0;
    for (double angle = 0.4; angle < 0.5; angle += 0.001) {
        const double share = f64::coneShare(at(angle), axis, inner, outer);
        EXPECT_LE(share, last);
        last = share;
    }
}

TEST(LightProfile, OfAConeWithoutFadingIsSharp) {
    const glm::dvec3 axis(0.0, 0.0, 1.0);
    const double versine = f64::versineOfAngle(0.4);
    EXPECT_EQ(f64::coneShare(at(0.4 - 1e-9), axis, versine, versine), 1.0);
    EXPECT_EQ(f64::coneShare(at(0.4 + 1e-9), axis, versine, versine), 0.0);
}

TEST(LightProfile, MeansOverTheSphereAreTheIntegrals) {
    const glm::dvec3 axis(0.0, 0.0, 1.0);
    for (const double half : {0.3, 1.0, 2.5, kPi}) {
        for (const double blend : {0.0, 0.15, 1.0}) {
            const double inner = f64::versineOfAngle(half * (1.0 - blend)), outer = f64::versineOfAngle(half);
            const double mean = sphereMean([&](double angle) { return f64::coneShare(at(angle), axis, inner, outer); });
            // a sharp edge lies somewhere in its cell of 1/200000
            EXPECT_NEAR(mean, f64::coneMeanShare(inner, outer), 5e-6) << half << " " << blend;
        }
    }
    const double cosine = sphereMean([&](double angle) { return f64::cosineShare(at(angle), axis); });
    EXPECT_NEAR(cosine, f64::cosineMeanShare(), 1e-9);
}

TEST(LightProfile, OfANarrowConeIsResolvedInSinglePrecision) {
    const float half = 0.005f;  // 1 - cos is 1.2e-5, two hundred units in the last place of 1
    const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, 0.2f, 1.0f));
    const glm::vec3 across = glm::normalize(glm::cross(axis, glm::vec3(1.0f, 0.0f, 0.0f)));
    for (const float angle : {0.0043f, 0.0045f, 0.0047f, 0.0049f}) {
        const float share = f32::coneShare(glm::normalize(axis + across * std::tan(angle)), axis,
                                           f32::versineOfAngle(0.0042f), f32::versineOfAngle(half));
        const double truth = f64::coneShare(at(double(angle)), {0.0, 0.0, 1.0}, f64::versineOfAngle(0.0042f),
                                            f64::versineOfAngle(double(half)));
        // rounding of the directions, 6e-8, against a fade of 8e-4, at a slope of at most 1.5 fades
        EXPECT_NEAR(share, truth, 5e-4) << angle;
    }
}

} // namespace
} // namespace eikonal

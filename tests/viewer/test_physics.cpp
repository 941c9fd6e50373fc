// The equations of shaders/physics, compiled as C++, against closed forms (docs/physics.md, section 7).
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "common/physics.h"

namespace eikonal {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

/// Direction behind the Luneburg lens n^2 = 2 - r^2 of a ray along +z with a given impact parameter, by leapfrog on the
/// analytic field; the first drift starts on the sphere, and the last is cut there.
double luneburgDeflection(double impact, double step) {
    const auto gradient = [](const glm::dvec3& x) {
        const double r2 = glm::dot(x, x);
        return r2 < 1.0 ? -x / std::sqrt(2.0 - r2) : glm::dvec3(0.0);
    };
    f64::Ray ray = {glm::dvec3(impact, 0.0, -std::sqrt(1.0 - impact * impact)), glm::dvec3(0.0, 0.0, 1.0)};
    while (true) {
        f64::Ray middle = f64::driftByLength(ray, 0.5 * step);
        f64::Ray next = f64::driftByLength(f64::kickByLength(middle, gradient(middle.x), step), 0.5 * step);
        if (glm::dot(next.x, next.x) >= 1.0) {
            // The share of the step inside, so that the exit does not spoil the order.
            double low = 0.0, high = step;
            for (int i = 0; i < 60; ++i) {
                const double h = 0.5 * (low + high);
                middle = f64::driftByLength(ray, 0.5 * h);
                next = f64::driftByLength(f64::kickByLength(middle, gradient(middle.x), h), 0.5 * h);
                (glm::dot(next.x, next.x) >= 1.0 ? high : low) = h;
            }
            return std::atan2(-next.w.x, next.w.z);
        }
        ray = next;
    }
}

TEST(Rays, LeapfrogIsOfSecondOrderInTheLuneburgLens) {
    const double impact = 0.6;
    double previous = 0.0;
    for (int halving = 0; halving < 6; ++halving) {
        const double error = std::abs(luneburgDeflection(impact, 0.1 / double(1 << halving)) - std::asin(impact));
        if (halving > 0) {
            const double order = std::log2(previous / error);
            EXPECT_GT(order, 1.9) << "halving " << halving;
            EXPECT_LT(order, 2.1) << "halving " << halving;
        }
        previous = error;
    }
}

TEST(Rays, LeapfrogKeepsAngularMomentumInASphericalField) {
    f64::Ray ray = {glm::dvec3(0.5, 0.0, -0.6), glm::dvec3(0.0, 0.2, 1.0)};
    const glm::dvec3 before = glm::cross(ray.x, ray.w);
    for (int i = 0; i < 200; ++i) {
        ray = f64::driftByLength(ray, 0.005);
        ray = f64::kickByLength(ray, -ray.x / std::sqrt(2.0 - glm::dot(ray.x, ray.x)), 0.01);
        ray = f64::driftByLength(ray, 0.005);
    }
    EXPECT_LT(glm::length(glm::cross(ray.x, ray.w) - before), 1e-14);
}

TEST(Fresnel, AgreesWithClosedForms) {
    const auto normal = f64::fresnelReflectance(1.0, 1.5, 0.0);
    EXPECT_NEAR(normal.s, 0.04, 1e-15);
    EXPECT_NEAR(normal.p, 0.04, 1e-15);
    const auto oblique = f64::fresnelReflectance(1.0, 1.5, std::sin(kTurn / 8.0));
    EXPECT_NEAR(0.5 * (oblique.s + oblique.p), 0.0502399, 1e-7);
    const double brewster = std::atan(1.5);
    EXPECT_NEAR(f64::fresnelReflectance(1.0, 1.5, std::sin(brewster)).p, 0.0, 1e-15);
}

TEST(Fresnel, IsTotalBeyondTheCriticalAngleAndTheSameBothWays) {
    for (const double w : {1.0001, 1.2, 1.49}) {
        const auto total = f64::fresnelReflectance(1.5, 1.0, w);
        EXPECT_NEAR(total.s, 1.0, 1e-12);
        EXPECT_NEAR(total.p, 1.0, 1e-12);
    }
    const auto in = f64::fresnelReflectance(1.0, 1.5, 0.7);
    const auto out = f64::fresnelReflectance(1.5, 1.0, 0.7);
    EXPECT_NEAR(in.s, out.s, 1e-15);
    EXPECT_NEAR(in.p, out.p, 1e-15);
}

TEST(PhaseFunction, IntegratesToOneWithMeanCosineG) {
    for (const double g : {-0.7, 0.0, 0.3, 0.9}) {
        double sum = 0.0, mean = 0.0;
        const int cells = 200000;
        for (int i = 0; i < cells; ++i) {
            const double cosine = -1.0 + 2.0 * (i + 0.5) / cells;
            const double weight = f64::henyeyGreenstein(cosine, g) * kTurn * 2.0 / cells;
            sum += weight;
            mean += weight * cosine;
        }
        EXPECT_NEAR(sum, 1.0, 1e-6);
        EXPECT_NEAR(mean, g, 1e-6);
    }
}

TEST(PhaseFunction, OfFluxErrsAsPredictedWhereTwoBeamsCross) {
    const double spread = 1e-5;  // 1 - |F|/E of two equal beams; the next order is 24 times it at g = 0.7
    for (const double g : {0.3, 0.7, -0.5}) {
        const double ahead = g < 0.0 ? -1.0 : 1.0;  // where p is largest
        const double exact = f64::henyeyGreenstein(ahead * (1.0 - spread), g);
        const double ofFlux = f64::phaseOfFlux({0.0, 0.0, -ahead}, {0.0, 0.0, 1.0 - spread}, g);
        const double error = std::abs(exact - ofFlux) / f64::henyeyGreenstein(ahead, g);
        EXPECT_NEAR(error / spread, f64::phaseErrorPerSpread(g), 1e-3 * f64::phaseErrorPerSpread(g)) << g;
    }
    EXPECT_EQ(f64::phaseErrorPerSpread(0.0), 0.0);
}

TEST(PhaseFunction, OfCrossingSheetsKeepsTheMeanCosine) {
    const glm::dvec3 flux(0.0, 0.0, 0.5);
    EXPECT_DOUBLE_EQ(f64::phaseOfFlux({0.0, 0.0, -1.0}, flux, 0.8), f64::henyeyGreenstein(1.0, 0.4));
    EXPECT_DOUBLE_EQ(f64::phaseOfFlux({0.0, 0.0, 1.0}, glm::dvec3(0.0), 0.8), 1.0 / (2.0 * kTurn));
}

TEST(Attenuation, MeanTransmittanceHasNoJumpAndIsBeerLambert) {
    EXPECT_DOUBLE_EQ(f64::meanTransmittance(0.0), 1.0);
    EXPECT_NEAR(f64::meanTransmittance(0.009999999), f64::meanTransmittance(0.010000001), 1e-8);
    EXPECT_NEAR(1.0 - 3.0 * f64::meanTransmittance(3.0), std::exp(-3.0), 1e-15);
    EXPECT_NEAR(f32::meanTransmittance(0.5f), (1.0 - std::exp(-0.5)) / 0.5, 1e-6);
}

TEST(EnvironmentMap, LiesAsOpenExrSays) {
    const glm::dvec2 front = f64::latLongFromDirection({0.0, 0.0, 1.0});
    EXPECT_NEAR(front.x, 0.5, 1e-15);
    EXPECT_NEAR(front.y, 0.5, 1e-15);
    EXPECT_NEAR(f64::latLongFromDirection({1.0, 0.0, 0.0}).x, 0.25, 1e-15);
    EXPECT_NEAR(f64::latLongFromDirection({0.0, 1.0, 0.0}).y, 0.0, 1e-15);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.4, 0.8));
    EXPECT_LT(glm::length(f64::directionFromLatLong(f64::latLongFromDirection(direction)) - direction), 1e-14);
}

TEST(EnvironmentMap, TurnsWithTheAngle) {
    const double quarter = kTurn / 4.0;
    const glm::dvec3 own = f64::turnedAboutY({1.0, 0.0, 0.0}, quarter);
    EXPECT_LT(glm::length(own - glm::dvec3(0.0, 0.0, 1.0)), 1e-15) << "what was at +Z is seen at +X";
}

TEST(ToneCurve, KeepsMiddleGreyAndRunsFromBlackToWhite) {
    EXPECT_NEAR(f64::toneAgx(glm::dvec3(0.18)).x, 0.18, 1e-12);
    EXPECT_NEAR(f64::toneAgx(glm::dvec3(0.0)).x, 0.0, 1e-9);
    EXPECT_NEAR(f64::toneAgx(glm::dvec3(0.18 * std::exp2(6.5))).x, 1.0, 1e-9);
    double last = -1.0;
    for (double stop = -12.0; stop < 8.0; stop += 0.05) {
        const double value = f64::toneAgx(glm::dvec3(0.18 * std::exp2(stop))).y;
        EXPECT_GE(value, last);
        last = value;
    }
    EXPECT_NEAR(f64::srgbEncoded(0.5), 0.735357, 1e-6);
    EXPECT_NEAR(f64::toneReinhard(glm::dvec3(1.0)).z, 0.5, 1e-15);
}

TEST(Box, SpanAndExitAgree) {
    const glm::dvec3 low(-1.0), high(1.0);
    const auto span = f64::boxSpan({-3.0, 0.2, 0.0}, {1.0, 0.0, 0.0}, low, high);
    EXPECT_DOUBLE_EQ(span.enter, 2.0);
    EXPECT_DOUBLE_EQ(span.leave, 4.0);
    const auto miss = f64::boxSpan({-3.0, 1.2, 0.0}, {1.0, 0.0, 0.0}, low, high);
    EXPECT_LT(miss.leave, miss.enter);
    EXPECT_DOUBLE_EQ(f64::distanceToExit({0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, low, high), 0.5);
}

TEST(Box, SliceIsMetInFrontAndWithinTheBox) {
    const glm::dvec3 low(-1.0), high(1.0);
    const auto met = f64::slicePoint({0.0, 0.0, 4.0}, {0.1, 0.0, -2.0}, 2, 0.5, low, high);
    EXPECT_TRUE(met.isMet);
    EXPECT_NEAR(glm::distance(met.x, {0.175, 0.0, 0.5}), 0.0, 1e-15);  // rounding
    EXPECT_FALSE(f64::slicePoint({0.0, 0.0, 4.0}, {0.1, 0.0, 2.0}, 2, 0.5, low, high).isMet) << "behind";
    EXPECT_FALSE(f64::slicePoint({0.0, 0.0, 4.0}, {0.7, 0.0, -2.0}, 2, 0.5, low, high).isMet) << "beside the box";
    EXPECT_FALSE(f64::slicePoint({0.0, 0.5, 4.0}, {0.1, 0.0, -2.0}, 1, 0.5, low, high).isMet) << "along its plane";
    EXPECT_FALSE(f64::slicePoint({0.0, 0.0, 4.0}, {0.1, 0.0, -2.0}, 1, 0.5, low, high).isMet) << "beside its plane";
}

TEST(Tube, SectionIsAcrossTheDirectionAndSigned) {
    const glm::dvec3 a(0.0), b(2.0, 0.0, 0.0), c(2.0, 3.0, 0.0), d(0.0, 3.0, 0.0);
    const glm::dvec3 oblique(0.6, 0.0, 0.8);
    EXPECT_NEAR(f64::crossSection(a, b, c, d, oblique), 6.0 * 0.8, 1e-14);
    EXPECT_NEAR(f64::crossSection(a, d, c, b, oblique), -6.0 * 0.8, 1e-14);
    EXPECT_NEAR(f64::coveredSection(a, d, c, b, oblique), 6.0 * 0.8, 1e-14);
}

TEST(Tube, CoversSomethingWhereAFoldRunsThroughIt) {
    // two corners have changed places: one half is inside out and cancels the other
    const glm::dvec3 a(0.0), b(2.0, 0.0, 0.0), c(0.0, 3.0, 0.0), d(2.0, 3.0, 0.0);
    EXPECT_NEAR(f64::crossSection(a, b, c, d, {0.0, 0.0, 1.0}), 0.0, 1e-14);
    EXPECT_NEAR(f64::coveredSection(a, b, c, d, {0.0, 0.0, 1.0}), 6.0, 1e-14);
}

} // namespace
} // namespace eikonal

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/shapes.h"

namespace eikonal {
namespace {

constexpr double kPi = std::numbers::pi;

struct NamedShape {
    const char* name;
    Shape shape;
    double volume;      ///< exact; 0: not checked
    double halfExtent;  ///< of a cube around the origin that holds the shape
};

std::vector<NamedShape> allShapes() {
    const double a = 0.9, b = 0.6, c = 0.5, r = 0.1;  // rounded box: Steiner's formula for the inner box
    const double ia = a - 2 * r, ib = b - 2 * r, ic = c - 2 * r;
    const double rounded = ia * ib * ic + 2 * r * (ia * ib + ib * ic + ic * ia) + kPi * r * r * (ia + ib + ic) +
                           4.0 / 3.0 * kPi * r * r * r;
    PlaneShape plane;
    plane.size = glm::dvec2(0.8, 0.6);
    return {
        {"sphere", SphereShape{0.4}, 4.0 / 3.0 * kPi * 0.064, 0.5},
        {"box", BoxShape{glm::dvec3(a, b, c)}, a * b * c, 0.5},
        {"rounded_box", RoundedBoxShape{glm::dvec3(a, b, c), r}, rounded, 0.5},
        {"cylinder", CylinderShape{0.3, 0.8}, kPi * 0.09 * 0.8, 0.5},
        {"torus", TorusShape{0.35, 0.12}, 2.0 * kPi * kPi * 0.35 * 0.0144, 0.5},
        {"prism", PrismShape{0.8, 0.7}, std::sqrt(3.0) / 4.0 * 0.64 * 0.7, 0.6},
        {"plane", plane, 0.0, 0.6},
        {"wine_glass", WineGlassShape{1.0}, 0.0, 0.55},
        {"wine", WineShape{1.0, 0.4}, 0.0, 0.55},
    };
}

glm::dvec3 gradientOf(const ShapeDistance& distance, const glm::dvec3& p, double h) {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = h;
        gradient[axis] = (distance(p + step) - distance(p - step)) / (2.0 * h);
    }
    return gradient;
}

/// Points of a low-discrepancy lattice in the cube (the plastic number's powers, M. Roberts 2018).
glm::dvec3 pointInCube(int n, double halfExtent) {
    const glm::dvec3 u = glm::fract(double(n) * glm::dvec3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703));
    return halfExtent * (2.0 * u - 1.0);
}

TEST(Shapes, DistanceGrowsByOnePerUnitNearlyEverywhere) {
    constexpr int kPoints = 4000;
    for (const NamedShape& named : allShapes()) {
        const ShapeDistance distance = signedDistanceOf(named.shape);
        int wrong = 0;
        for (int n = 0; n < kPoints; ++n) {
            const glm::dvec3 p = pointInCube(n, 1.2 * named.halfExtent);
            wrong += std::abs(glm::length(gradientOf(distance, p, 1e-6)) - 1.0) > 1e-4 ? 1 : 0;
        }
        // Differences fail only within 1e-6 of the medial surface, whose share of the volume is about as small.
        EXPECT_LE(wrong, kPoints / 500) << named.name;
    }
}

TEST(Shapes, DistanceReachesExactlyTheSurface) {
    // Sphere tracing back along the gradient by d must end on the surface: distances are exact, not only bounds.
    for (const NamedShape& named : allShapes()) {
        const ShapeDistance distance = signedDistanceOf(named.shape);
        double worst = 0.0;
        int outside = 0;
        for (int n = 0; n < 500; ++n) {
            const glm::dvec3 p = pointInCube(n, 1.2 * named.halfExtent);
            const double d = distance(p);
            if (d <= 0.0)
                continue;
            ++outside;
            worst = std::max(worst, std::abs(distance(p - d * glm::normalize(gradientOf(distance, p, 1e-6)))));
        }
        EXPECT_GT(outside, 50) << named.name;
        EXPECT_LT(worst, 1e-4) << named.name;  // error of the differences times d
    }
}

TEST(Shapes, VolumeIsThatOfTheFormula) {
    for (const NamedShape& named : allShapes()) {
        if (named.volume == 0.0)
            continue;
        const ShapeDistance distance = signedDistanceOf(named.shape);
        constexpr int kCells = 60;
        const double h = 2.0 * named.halfExtent / kCells;
        double volume = 0.0;
        for (int k = 0; k < kCells; ++k)
            for (int j = 0; j < kCells; ++j)
                for (int i = 0; i < kCells; ++i) {
                    const glm::dvec3 p = h * (glm::dvec3(i, j, k) + 0.5) - named.halfExtent;
                    volume += h * h * h * std::clamp(0.5 - distance(p) / h, 0.0, 1.0);
                }
        // The linear ramp over a cell errs where faces are oblique or meet in edges: below 0.5 % at this fineness.
        EXPECT_NEAR(volume / named.volume, 1.0, 5e-3) << named.name;
    }
}

TEST(Shapes, PlaneIsSolidBelowItsSurface) {
    const ShapeDistance distance = signedDistanceOf(PlaneShape{glm::dvec2(2.0, 2.0), {}});
    EXPECT_DOUBLE_EQ(distance({0.0, 0.3, 0.0}), 0.3);
    EXPECT_DOUBLE_EQ(distance({0.0, -0.3, 0.0}), -0.3);
    EXPECT_DOUBLE_EQ(distance({1.5, -5.0, 0.0}), 0.5);
}

TEST(Shapes, WineGlassHasAFootAStemAndAHollowBowl) {
    const ShapeDistance glass = signedDistanceOf(WineGlassShape{2.0});
    EXPECT_NEAR(glass({0.0, -1.0, 0.0}), 0.0, 1e-12);  // stands at -height / 2
    EXPECT_NEAR(glass({0.0, 1.1, 0.0}), std::hypot(0.37, 0.13) - 0.03, 1e-3);  // the rim is nearest
    EXPECT_LT(glass({0.0, -0.5, 0.0}), 0.0);           // stem
    EXPECT_GT(glass({0.0, 0.4, 0.0}), 0.3);            // inside the bowl
    EXPECT_GT(glass({0.2, -0.5, 0.0}), 0.1);           // beside the stem
    // The wall is 3 % of the height thick where the bowl is widest: 0.06, from the middle 0.03 to either side.
    EXPECT_NEAR(glass({0.5, 2.0 * 0.68 - 1.0, 0.0}), -0.03, 1e-4);
    EXPECT_NEAR(glass({0.0, 0.0, 0.53}), glass({0.53, 0.0, 0.0}), 1e-12);  // revolved
}

TEST(Shapes, WineFillsTheBowlUpToItsWall) {
    constexpr double kHeight = 1.5;
    const ShapeDistance glass = signedDistanceOf(WineGlassShape{kHeight});
    const ShapeDistance wine = signedDistanceOf(WineShape{kHeight, 0.5});
    const double level = kHeight * (kBowlBottom + 0.5 * (kBowlTop - kBowlBottom) - 0.5);
    double largestGap = -1.0;
    for (int n = 0; n < 4000; ++n) {
        const glm::dvec3 p = pointInCube(n, 0.5);
        bool inBowl = p.y > kHeight * (kBowlBottom - 0.5) && p.y < level;
        for (double t = 0.0; t <= 1.0 && inBowl; t += 0.01)  // nothing of the glass between the axis and the point
            inBowl = glass({t * p.x, p.y, t * p.z}) > 0.0;
        if (inBowl)
            largestGap = std::max(largestGap, wine(p));
    }
    EXPECT_GT(largestGap, -0.1) << "no point was in the bowl";
    EXPECT_LE(largestGap, 0.0);  // no air between the wine and the wall
    EXPECT_NEAR(wine({0.0, level + 0.1, 0.0}), 0.1, 1e-12);
    EXPECT_LT(wine({0.0, level - 0.1, 0.0}), 0.0);
    // It ends in the middle of the wall, half of 3 % of the height inside the glass.
    EXPECT_NEAR(wine({0.25 * kHeight, kHeight * 0.18 - 1e-3, 0.0}), 0.0, 2e-3);
}

TEST(Shapes, FullerGlassesHoldMore) {
    const ShapeDistance half = signedDistanceOf(WineShape{1.0, 0.5}), full = signedDistanceOf(WineShape{1.0, 1.0});
    const glm::dvec3 p(0.0, 0.3, 0.0);
    EXPECT_GT(half(p), 0.0);
    EXPECT_LT(full(p), 0.0);
}

} // namespace
} // namespace eikonal

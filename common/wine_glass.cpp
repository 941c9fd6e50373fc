// The wine glass: foot, stem, and a bowl whose wall follows one curve at constant thickness.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/shapes.h"

namespace eikonal {
namespace {

using glm::dvec2;

/// Cubic Bézier curve in (radius, height above the foot), for a glass of height 1.
struct Bezier {
    std::array<dvec2, 4> p;

    dvec2 at(double t) const {
        const double s = 1.0 - t;
        return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
    }
    /// Unit normal to the right of the direction of travel: outwards for the bowl, drawn from the axis up to the rim.
    dvec2 normal(double t) const {
        const double s = 1.0 - t;
        const dvec2 tangent = s * s * (p[1] - p[0]) + 2.0 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]);
        return glm::normalize(dvec2(tangent.y, -tangent.x));
    }
};

constexpr double kHalfWall = 0.5 * kGlassWall;
constexpr double kMiddleBottom = kBowlBottom - kHalfWall;
constexpr int kStepsPerCurve = 48;

/// Middle of the wall from the axis to the widest place, and on to the rim.
const Bezier kBelly{{dvec2(0.0, kMiddleBottom), dvec2(0.16, kMiddleBottom), dvec2(0.25, 0.54), dvec2(0.25, 0.68)}};
const Bezier kNeck{{dvec2(0.25, 0.68), dvec2(0.25, 0.80), dvec2(0.205, 0.90), dvec2(0.185, kBowlTop)}};

void append(std::vector<dvec2>& points, const Bezier& curve, double offset, double from, double to) {
    for (int i = 1; i <= kStepsPerCurve; ++i) {
        const double t = from + (to - from) * double(i) / kStepsPerCurve;
        points.push_back(curve.at(t) + offset * curve.normal(t));
    }
}

/// Half turn from the outer to the inner side of the wall.
void appendRim(std::vector<dvec2>& points) {
    const dvec2 outward = kNeck.normal(1.0), upward(-outward.y, outward.x);
    constexpr int kSteps = 16;
    for (int i = 1; i < kSteps; ++i) {
        const double angle = std::numbers::pi * double(i) / kSteps;
        points.push_back(kNeck.at(1.0) + kHalfWall * (std::cos(angle) * outward + std::sin(angle) * upward));
    }
}

/// From the axis below the foot, around its edge, up the stem, ending where the bowl's outside begins.
void appendFootAndStem(std::vector<dvec2>& points, const dvec2& bowl, const dvec2& bowlDirection) {
    points.emplace_back(0.0, 0.0);
    points.emplace_back(0.205, 0.0);
    append(points, Bezier{{dvec2(0.205, 0.0), dvec2(0.216, 0.0), dvec2(0.216, 0.014), dvec2(0.205, 0.016)}}, 0.0, 0, 1);
    append(points, Bezier{{dvec2(0.205, 0.016), dvec2(0.12, 0.03), dvec2(0.026, 0.03), dvec2(0.024, 0.12)}}, 0.0, 0, 1);
    append(points, Bezier{{dvec2(0.024, 0.12), dvec2(0.022, 0.22), dvec2(0.022, 0.25), dvec2(0.024, 0.33)}}, 0.0, 0, 1);
    append(points, Bezier{{dvec2(0.024, 0.33), dvec2(0.026, 0.39), bowl - 0.05 * bowlDirection, bowl}}, 0.0, 0, 1);
}

std::vector<dvec2> scaledAndCentred(std::vector<dvec2> points, double height) {
    for (dvec2& point : points)
        point = height * (glm::max(point, dvec2(0.0)) - dvec2(0.0, 0.5));
    return points;
}

} // namespace

std::vector<dvec2> wineGlassProfile(double height) {
    constexpr double kStemEnds = 0.3;  // parameter of the belly
    std::vector<dvec2> points;
    const dvec2 outward = kBelly.normal(kStemEnds);
    appendFootAndStem(points, kBelly.at(kStemEnds) + kHalfWall * outward, dvec2(-outward.y, outward.x));
    append(points, kBelly, kHalfWall, kStemEnds, 1.0);
    append(points, kNeck, kHalfWall, 0.0, 1.0);
    appendRim(points);
    points.push_back(kNeck.at(1.0) - kHalfWall * kNeck.normal(1.0));
    append(points, kNeck, -kHalfWall, 1.0, 0.0);
    append(points, kBelly, -kHalfWall, 1.0, 0.0);
    return scaledAndCentred(std::move(points), height);
}

std::vector<dvec2> wineProfile(double height, double fill) {
    const double level = kBowlBottom + fill * (kBowlTop - kBowlBottom);
    std::vector<dvec2> wall{kBelly.at(0.0)};
    append(wall, kBelly, 0.0, 0.0, 1.0);
    append(wall, kNeck, 0.0, 0.0, 1.0);
    std::vector<dvec2> points;
    for (std::size_t i = 0; i < wall.size() && wall[i].y < level; ++i)
        points.push_back(wall[i]);
    if (points.size() < wall.size()) {  // the wall meets the surface between two points
        const dvec2 below = points.back(), above = wall[points.size()];
        points.push_back(below + (above - below) * (level - below.y) / (above.y - below.y));
    }
    points.emplace_back(0.0, level);
    return scaledAndCentred(std::move(points), height);
}

} // namespace eikonal

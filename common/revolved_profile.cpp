// Signed distance to a revolved polyline. Segments stand in runs with bounds, so that far runs cost one comparison.

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/shapes.h"

namespace eikonal {
namespace {

using glm::dvec2;

double squaredDistanceToSegment(const dvec2& point, const dvec2& a, const dvec2& b) {
    const dvec2 edge = b - a, offset = point - a;
    const double length2 = glm::dot(edge, edge);
    const double along = length2 > 0.0 ? std::clamp(glm::dot(offset, edge) / length2, 0.0, 1.0) : 0.0;
    const dvec2 away = offset - along * edge;
    return glm::dot(away, away);
}

/// Whether the ray from the point outwards, at constant height, crosses the segment. Counted over the closed curve the
/// crossings are odd inside; the axis lies behind every point and needs no count.
bool crossesOutward(const dvec2& point, const dvec2& a, const dvec2& b) {
    if ((a.y > point.y) == (b.y > point.y))
        return false;
    return a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) > point.x;
}

} // namespace

RevolvedProfile::RevolvedProfile(std::vector<dvec2> points) : points_(std::move(points)) {
    constexpr std::size_t kSegmentsPerRun = 12;
    for (std::size_t first = 0; first + 1 < points_.size(); first += kSegmentsPerRun) {
        Run run{first, std::min(first + kSegmentsPerRun, points_.size() - 1), points_[first], points_[first]};
        for (std::size_t i = run.first; i <= run.last; ++i) {
            run.low = glm::min(run.low, points_[i]);
            run.high = glm::max(run.high, points_[i]);
        }
        runs_.push_back(run);
    }
}

double RevolvedProfile::distance(const glm::dvec3& point) const {
    const dvec2 p(std::hypot(point.x, point.z), point.y);
    const auto squaredDistanceToBounds = [&](const Run& run) {
        const dvec2 beyond = glm::max(glm::max(run.low - p, p - run.high), dvec2(0.0));
        return glm::dot(beyond, beyond);
    };
    // A good first guess, one point of the run whose bounds are nearest, spares most of the others.
    const Run& guess = *std::min_element(runs_.begin(), runs_.end(), [&](const Run& a, const Run& b) {
        return squaredDistanceToBounds(a) < squaredDistanceToBounds(b);
    });
    const dvec2 toGuess = points_[guess.first] - p;
    double nearest2 = glm::dot(toGuess, toGuess);
    bool inside = false;
    for (const Run& run : runs_) {
        const bool near = squaredDistanceToBounds(run) < nearest2;
        const bool level = p.y >= run.low.y && p.y <= run.high.y && p.x <= run.high.x;
        for (std::size_t i = run.first; i < run.last && (near || level); ++i) {
            if (near)
                nearest2 = std::min(nearest2, squaredDistanceToSegment(p, points_[i], points_[i + 1]));
            if (level && crossesOutward(p, points_[i], points_[i + 1]))
                inside = !inside;
        }
    }
    return inside ? -std::sqrt(nearest2) : std::sqrt(nearest2);
}

} // namespace eikonal

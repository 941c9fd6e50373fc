#include "common/shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace eikonal {
namespace {

using glm::dvec2;
using glm::dvec3;

/// From distances along independent directions, each beyond its own face: outside the corner counts, inside the nearest
/// face.
double cornerDistance(const dvec2& q) { return glm::length(glm::max(q, dvec2(0.0))) + std::min(std::max(q.x, q.y), 0.0); }

double cornerDistance(const dvec3& q) {
    return glm::length(glm::max(q, dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

double boxDistance(const dvec3& p, const dvec3& size) { return cornerDistance(glm::abs(p) - 0.5 * size); }

double roundedBoxDistance(const dvec3& p, const RoundedBoxShape& box) {
    return boxDistance(p, box.size - 2.0 * box.radius) - box.radius;
}

double cylinderDistance(const dvec3& p, const CylinderShape& cylinder) {
    return cornerDistance(dvec2(std::hypot(p.x, p.z) - cylinder.radius, std::abs(p.y) - 0.5 * cylinder.height));
}

double torusDistance(const dvec3& p, const TorusShape& torus) {
    return std::hypot(std::hypot(p.x, p.z) - torus.radius, p.y) - torus.tube;
}

/// Equilateral triangle around the origin, one corner up.
double triangleDistance(const dvec2& point, double side) {
    const double inradius = side / (2.0 * std::numbers::sqrt3);
    const dvec2 corners[] = {dvec2(0.0, 2.0 * inradius), dvec2(-0.5 * side, -inradius), dvec2(0.5 * side, -inradius)};
    double nearest = std::numeric_limits<double>::infinity();
    double deepest = -std::numeric_limits<double>::infinity();  // signed distance beyond the edges' lines
    for (int i = 0; i < 3; ++i) {
        const dvec2 edge = corners[(i + 1) % 3] - corners[i];
        const dvec2 offset = point - corners[i];
        const double along = std::clamp(glm::dot(offset, edge) / glm::dot(edge, edge), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(offset - along * edge));
        deepest = std::max(deepest, glm::dot(offset, dvec2(edge.y, -edge.x)) / glm::length(edge));
    }
    return deepest > 0.0 ? nearest : deepest;
}

double prismDistance(const dvec3& p, const PrismShape& prism) {
    return cornerDistance(dvec2(triangleDistance(dvec2(p.x, p.y), prism.side), std::abs(p.z) - 0.5 * prism.height));
}

double planeDistance(const dvec3& p, const PlaneShape& plane) {
    return cornerDistance(dvec3(std::abs(p.x) - 0.5 * plane.size.x, p.y, std::abs(p.z) - 0.5 * plane.size.y));
}

ShapeDistance revolved(std::vector<dvec2> points) {
    auto profile = std::make_shared<const RevolvedProfile>(std::move(points));
    return [profile](const dvec3& p) { return profile->distance(p); };
}

struct DistanceMaker {
    ShapeDistance operator()(const SphereShape& s) const {
        return [s](const dvec3& p) { return glm::length(p) - s.radius; };
    }
    ShapeDistance operator()(const BoxShape& s) const {
        return [s](const dvec3& p) { return boxDistance(p, s.size); };
    }
    ShapeDistance operator()(const RoundedBoxShape& s) const {
        return [s](const dvec3& p) { return roundedBoxDistance(p, s); };
    }
    ShapeDistance operator()(const CylinderShape& s) const {
        return [s](const dvec3& p) { return cylinderDistance(p, s); };
    }
    ShapeDistance operator()(const TorusShape& s) const {
        return [s](const dvec3& p) { return torusDistance(p, s); };
    }
    ShapeDistance operator()(const PrismShape& s) const {
        return [s](const dvec3& p) { return prismDistance(p, s); };
    }
    ShapeDistance operator()(const PlaneShape& s) const {
        return [s](const dvec3& p) { return planeDistance(p, s); };
    }
    ShapeDistance operator()(const WineGlassShape& s) const { return revolved(wineGlassProfile(s.height)); }
    ShapeDistance operator()(const WineShape& s) const { return revolved(wineProfile(s.height, s.fill)); }
    ShapeDistance operator()(const FieldShape& s) const {
        return [s](const dvec3& p) { return boxDistance(p, s.size); };
    }
    ShapeDistance operator()(const MeshShape&) const { return noFormula(); }
    ShapeDistance operator()(const VolumeShape&) const { return noFormula(); }

    static ShapeDistance noFormula() {
        assert(false && "meshes and volumes have no formula");
        return {};
    }
};

} // namespace

ShapeDistance signedDistanceOf(const Shape& shape) { return std::visit(DistanceMaker{}, shape); }

} // namespace eikonal

#include "common/object_bounds.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "common/shapes.h"
#include "common/vdb_io.h"

namespace eikonal {
namespace {

using glm::dvec3;

constexpr double kNever = std::numeric_limits<double>::infinity();

Bounds centred(const dvec3& size) { return {-0.5 * size, 0.5 * size}; }

Bounds revolved(const std::vector<glm::dvec2>& profile) {
    Bounds box{dvec3(0.0, kNever, 0.0), dvec3(0.0, -kNever, 0.0)};
    for (const glm::dvec2& point : profile) {
        const dvec3 reach(point.x, point.y, point.x);
        box.min = glm::min(box.min, dvec3(-point.x, point.y, -point.x));
        box.max = glm::max(box.max, reach);
    }
    return box;
}

/// The box of a box's corners in other coordinates.
Bounds mapped(const Bounds& box, const glm::dmat4& map) {
    Bounds result{dvec3(kNever), dvec3(-kNever)};
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const dvec3 at(map * glm::dvec4(glm::mix(box.min, box.max, side), 1.0));
        result.min = glm::min(result.min, at);
        result.max = glm::max(result.max, at);
    }
    return result;
}

/// To the outer edges of the voxels of every grid.
Bounds ofVolume(const VdbFile& file) {
    Bounds result{dvec3(kNever), dvec3(-kNever)};
    for (const VdbGrid& grid : file.grids) {
        const Bounds box = mapped({dvec3(-0.5), dvec3(grid.size()) - 0.5}, grid.worldFromIndex);
        result.min = glm::min(result.min, box.min);
        result.max = glm::max(result.max, box.max);
    }
    return result;
}

struct BoundsMaker {
    const Scene& scene;
    double scale;  // of the object

    Bounds operator()(const SphereShape& s) const { return centred(dvec3(2.0 * s.radius)); }
    Bounds operator()(const BoxShape& s) const { return centred(s.size); }
    Bounds operator()(const RoundedBoxShape& s) const { return centred(s.size); }
    Bounds operator()(const CylinderShape& s) const { return centred({2.0 * s.radius, s.height, 2.0 * s.radius}); }
    Bounds operator()(const TorusShape& s) const {
        const double across = 2.0 * (s.radius + s.tube);
        return centred({across, 2.0 * s.tube, across});
    }
    Bounds operator()(const PrismShape& s) const {
        const double inradius = s.side / (2.0 * std::numbers::sqrt3);
        return {{-0.5 * s.side, -inradius, -0.5 * s.height}, {0.5 * s.side, 2.0 * inradius, 0.5 * s.height}};
    }
    /// Solid without end below y = 0: as deep as the domain is long.
    Bounds operator()(const PlaneShape& s) const {
        const double depth = glm::length(scene.domain.max - scene.domain.min) / scale;
        return {{-0.5 * s.size.x, -depth, -0.5 * s.size.y}, {0.5 * s.size.x, 0.0, 0.5 * s.size.y}};
    }
    Bounds operator()(const WineGlassShape& s) const { return revolved(wineGlassProfile(s.height)); }
    Bounds operator()(const WineShape& s) const { return revolved(wineProfile(s.height, s.fill)); }
    Bounds operator()(const FieldShape& s) const { return centred(s.size); }
    Bounds operator()(const MeshShape& s) const { return boundsOf(loadSolidMesh(scene.resolve(s.file)).mesh); }
    Bounds operator()(const VolumeShape& s) const { return ofVolume(readVdb(scene.resolve(s.file))); }
};

/// Whether b's box, mapped to the coordinates of a, misses a's along one of its axes.
bool isApart(const Object& a, const Bounds& boxOfA, const Object& b, const Bounds& boxOfB, double widening) {
    const Bounds box = mapped(boxOfB, glm::inverse(a.worldFromLocal()) * b.worldFromLocal());
    const dvec3 slack(widening / a.scale);
    return glm::any(glm::lessThan(box.max + slack, boxOfA.min)) || glm::any(glm::greaterThan(box.min - slack, boxOfA.max));
}

} // namespace

Bounds boundsOf(const Scene& scene, const Object& object) { return std::visit(BoundsMaker{scene, object.scale}, object.shape); }

bool mayOverlap(const Object& a, const Bounds& boxOfA, const Object& b, const Bounds& boxOfB, double widening) {
    return !isApart(a, boxOfA, b, boxOfB, widening) && !isApart(b, boxOfB, a, boxOfA, widening);
}

} // namespace eikonal

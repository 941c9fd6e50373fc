#include "lightsim/emit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/device_frame.h"
#include "lightsim/point_source.h"
#include "lightsim/settings.h"

namespace eikonal::bake {

namespace {

using glm::dvec2;
using glm::dvec3;

// Launch rectangles end this share inside the silhouette of the domain, so that rays along its faces do not miss it by
// rounding.
constexpr double kInset = 1e-5;
// A window towards the domain serves lights that see all of it within about 70 degrees of its centre.
constexpr double kMinWindowCosine = 0.35;
// Cells of grids about a light nearby, where they are of their usual width.
constexpr double kNearCells = 16.0;   // per side of a cube face about a light inside the domain
constexpr double kCloseCells = 64.0;  // the same for a light just outside
constexpr double kConeCells = 64.0;   // per side of the square about a cone, at least: its edge is a few of them wide
constexpr double kPencilCells = 24.0;  // the same for a beam of a few voxels, whose edge no voxel resolves
constexpr long kLeastNearCells = 4;   // whatever their width: rays of a face are evenly spread by tangents, not by angles
constexpr double kPencilCellVoxels = 0.125;

struct Window {
    dvec2 low{1e300}, high{-1e300};
    void include(const dvec2& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

std::array<dvec3, 8> cornersOf(const Lattice& lattice) {
    std::array<dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const dvec3 side(i & 1, (i >> 1) & 1, i >> 2);
        corners[std::size_t(i)] = lattice.min + side * lattice.extent();
    }
    return corners;
}

std::uint32_t cellsAlong(double length, double maxSide) {
    return std::uint32_t(std::clamp(std::ceil(length / maxSide * (1.0 - 1e-9)), 1.0, 65535.0));
}

double projectedArea(const Lattice& lattice, const dvec3& direction) {
    const dvec3 e = lattice.extent();
    return std::abs(direction.x) * e.y * e.z + std::abs(direction.y) * e.z * e.x + std::abs(direction.z) * e.x * e.y;
}

double strongestOf(const dvec3& power) { return std::max({power.x, power.y, power.z}); }

class GridBuilder {
public:
    GridBuilder(const Lattice& lattice, const Criteria& criteria)
        : lattice_{deviceFromWorld(lattice, lattice.min), lattice.voxel, lattice.size}, middle_(middleOf(lattice)),
          criteria_(criteria) {}

    void add(const DirectionalLight& light) { add(std::vector{light}); }

    void add(const PointLight& light) {
        grids_.emitted += light.power;
        push(framesOf(onDevice(pointSourceOf(light))), 1, kNoLimit);
    }

    void add(const SpotLight& light) {
        grids_.emitted += light.power;
        push(framesOf(onDevice(pointSourceOf(light))), 1, strongestOf(light.power));
    }

    void add(const RectangleLight& light) {
        grids_.emitted += light.power;
        const std::vector<PointSource> sources = pointSourcesOf(light);
        std::vector<LaunchFrame> frames;
        for (const PointSource& source : sources) {
            const std::vector<LaunchFrame> more = framesOf(onDevice(source));
            frames.insert(frames.end(), more.begin(), more.end());
        }
        push(frames, sources.size(), strongestOf(light.power));
    }

    /// One light, whatever the number of its beams.
    void add(const std::vector<DirectionalLight>& beams) {
        std::vector<LaunchFrame> frames;
        for (const DirectionalLight& beam : beams) {
            grids_.emitted += beam.irradiance * projectedArea(lattice_, glm::normalize(beam.direction));
            frames.push_back(beamFrame(beam));
        }
        push(frames, beams.size(), kNoLimit);
    }

    LaunchGrids take() { return std::move(grids_); }

private:
    static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

    PointSource onDevice(PointSource source) const {
        source.position -= middle_;
        return source;
    }

    LaunchFrame beamFrame(const DirectionalLight& light) const {
        const dvec3 direction = glm::normalize(light.direction);
        const auto [u, v] = axesAcross(direction);
        Window window;
        double nearest = 1e300;
        for (const dvec3& corner : cornersOf(lattice_)) {
            window.include({glm::dot(corner, u), glm::dot(corner, v)});
            nearest = std::min(nearest, glm::dot(corner, direction));
        }
        const dvec2 middle = 0.5 * (window.low + window.high);
        const dvec2 half = 0.5 * (1.0 - kInset) * (window.high - window.low);
        LaunchFrame frame{};
        frame.origin = direction;
        frame.centre = u * middle.x + v * middle.y + direction * nearest;
        frame.strength = light.irradiance;
        placeAxes(frame, u * half.x, v * half.y);
        return frame;
    }

    /// The smaller one of the windows towards the domain and about the source's cone; a cube where there is neither.
    std::vector<LaunchFrame> framesOf(const PointSource& source) const {
        const dvec3 nearest = glm::clamp(source.position, lattice_.min, lattice_.max());
        const double distance = glm::distance(nearest, source.position);
        const dvec3 towardsDomain = lattice_.min + 0.5 * lattice_.extent() - source.position;
        std::vector<LaunchFrame> frames;
        if (distance > 0.0 && seenInWindow(source.position, towardsDomain)) {
            frames = {windowFrame(source, towardsDomain, distance)};
        }
        if (source.profile == PROFILE_CONE && 1.0 - source.coneOuter > kMinWindowCosine) {
            const LaunchFrame cone = coneFrame(source, towardsDomain, distance);
            if (frames.empty() || windowTangent(cone) < windowTangent(frames.front())) {
                frames = {cone};
            }
        }
        return frames.empty() ? cubeFrames(source, distance) : frames;
    }

    /// Of half the angle that a square about the window subtends.
    static double windowTangent(const LaunchFrame& frame) {
        return double(std::max(glm::length(frame.a), glm::length(frame.b)) / glm::length(frame.axis));
    }

    bool seenInWindow(const dvec3& position, const dvec3& axis) const {
        const auto corners = cornersOf(lattice_);
        return std::all_of(corners.begin(), corners.end(), [&](const dvec3& corner) {
            const dvec3 towards = corner - position;
            return glm::dot(towards, axis) > kMinWindowCosine * glm::length(towards) * glm::length(axis);
        });
    }

    /// One grid on the plane through the domain's centre, as wide as the domain's shadow on it.
    LaunchFrame windowFrame(const PointSource& source, const dvec3& axis, double distance) const {
        const double axisLength = glm::length(axis);
        const dvec3 direction = axis / axisLength;
        const auto [u, v] = axesAcross(direction);
        double halfU = 0.0, halfV = 0.0;
        for (const dvec3& corner : cornersOf(lattice_)) {
            const dvec3 towards = corner - source.position;
            const dvec3 onPlane = towards * (axisLength / glm::dot(towards, direction)) - axis;
            halfU = std::max(halfU, std::abs(glm::dot(onPlane, u)));
            halfV = std::max(halfV, std::abs(glm::dot(onPlane, v)));
        }
        LaunchFrame frame = pointFrame(source, axis, distance);
        placeAxes(frame, u * halfU, v * halfV);
        return frame;
    }

    /// A square about a cone, on a plane across its axis at the depth of the domain.
    LaunchFrame coneFrame(const PointSource& source, const dvec3& towardsDomain, double distance) const {
        const double depth =
            distance > 0.0 ? std::max(distance, glm::dot(towardsDomain, source.axis)) : lattice_.voxel;
        const double cosine = 1.0 - source.coneOuter;
        const double half = depth * std::sqrt(source.coneOuter * (1.0 + cosine)) / cosine;
        const auto [u, v] = axesAcross(source.axis);
        LaunchFrame frame = pointFrame(source, source.axis * depth, distance);
        placeAxes(frame, u * half, v * half);
        const double beamCells = 2.0 * half / (kPencilCellVoxels * lattice_.voxel);
        const double usual = distance > 0.0 ? std::clamp(std::floor(beamCells), kPencilCells, kConeCells) : kConeCells;
        const std::uint32_t least = nearCells(usual);
        frame.cellsU = std::max(frame.cellsU, least);
        frame.cellsV = std::max(frame.cellsV, least);
        return frame;
    }

    /// Faces of a cube about the source, in front of its axis and around it; those that get no light are left out.
    std::vector<LaunchFrame> cubeFrames(const PointSource& source, double distance) const {
        std::vector<LaunchFrame> frames;
        const auto [across, along] = axesAcross(source.axis);
        const std::array<dvec3, 3> basis{source.axis * lattice_.voxel, across * lattice_.voxel, along * lattice_.voxel};
        for (std::size_t face = 0; face < 6; ++face) {
            const dvec3 axis = face % 2 == 0 ? basis[face / 2] : -basis[face / 2];
            const dvec3 u = basis[(face / 2 + 1) % 3];
            const dvec3 v = basis[(face / 2 + 2) % 3];
            // Only the face behind can be dark, and a profile reaches its corners first. Cones that end before the corners
            // of the others are launched through a window.
            const bool dark = source.shareAlong(axis + u + v) + source.shareAlong(axis + u - v) +
                                  source.shareAlong(axis - u + v) + source.shareAlong(axis - u - v) <= 0.0;
            if (dark) {
                continue;
            }
            LaunchFrame frame = pointFrame(source, axis, distance);
            frame.a = u;
            frame.b = v;
            frame.cellsU = frame.cellsV = nearCells(distance > 0.0 ? kCloseCells : kNearCells);
            frames.push_back(frame);
        }
        return frames;
    }

    std::uint32_t nearCells(double usual) const {
        return std::uint32_t(std::max(std::lround(usual / criteria_.coarseness), kLeastNearCells));
    }

    LaunchFrame pointFrame(const PointSource& source, const dvec3& axis, double distance) const {
        LaunchFrame frame{};
        frame.isPoint = 1u;
        frame.origin = source.position;
        frame.axis = axis;
        frame.centre = source.position + axis;
        frame.phase = float(glm::length(axis) - distance);
        frame.pathBefore = float(distance);
        frame.strength = source.intensity;
        frame.profile = source.profile;
        frame.profileAxis = source.axis;
        frame.coneInner = float(source.coneInner);
        frame.coneOuter = float(source.coneOuter);
        return frame;
    }

    void placeAxes(LaunchFrame& frame, const dvec3& a, const dvec3& b) const {
        frame.a = a;
        frame.b = b;
        frame.cellsU = cellsAlong(2.0 * glm::length(a), criteria_.maxSide);
        frame.cellsV = cellsAlong(2.0 * glm::length(b), criteria_.maxSide);
    }

    /// A point light's frame is densest where its axis meets it.
    static double cellPowerBound(const LaunchFrame& frame) {
        const double area = 4.0 * double(glm::length(glm::cross(frame.a, frame.b))) / double(frame.cellsU * frame.cellsV);
        const double distance2 = frame.isPoint != 0u ? double(glm::dot(frame.axis, frame.axis)) : 1.0;
        return strongestOf(frame.strength) * area / distance2;
    }

    /// The frames of one light, of so many sources that it is simulated as. What patches of different sources misplace adds
    /// in squares. Where the frames have a profile they launch less than the bound: not more than `limit`.
    void push(const std::vector<LaunchFrame>& frames, std::size_t sources, double limit) {
        double bound = 0.0;
        for (const LaunchFrame& frame : frames) {
            grids_.strongestCellPower = std::max(grids_.strongestCellPower, cellPowerBound(frame));
            bound += cellPowerBound(frame) * frame.cellsU * frame.cellsV;
        }
        for (LaunchFrame frame : frames) {
            frame.splitPower = float(criteria_.splitShare * std::min(bound, limit) / std::sqrt(double(sources)));
            frame.firstCell = grids_.cellCount;
            grids_.cellCount += frame.cellsU * frame.cellsV;
            grids_.frames.push_back(frame);
        }
        grids_.strongestPower += bound;
    }

    Lattice lattice_;  ///< of the domain, about the origin, as positions on the device are
    dvec3 middle_;     ///< where in the world that is
    Criteria criteria_;
    LaunchGrids grids_;
};

} // namespace

LaunchGrids launchGrids(const LightSet& lights, const Lattice& lattice, const Criteria& criteria) {
    GridBuilder builder(lattice, criteria);
    for (const Light& light : lights.lights) {
        std::visit([&](const auto& one) { builder.add(one); }, light);
    }
    builder.add(lights.environment);
    return builder.take();
}

} // namespace eikonal::bake

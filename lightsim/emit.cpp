#include "lightsim/emit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eikonal::bake {

namespace {

using glm::dvec2;
using glm::dvec3;

// Launch rectangles end this share inside the silhouette of the domain, so that rays along its faces do not miss it by
// rounding.
constexpr double kInset = 1e-5;
// A window towards the domain serves lights that see all of it within about 70 degrees of its centre.
constexpr double kMinWindowCosine = 0.35;
constexpr std::uint32_t kNearCells = 16;   // per side of a cube face about a light inside the domain
constexpr std::uint32_t kCloseCells = 64;  // the same for a light just outside

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

/// Two unit vectors across `direction`: coordinate axes where it is one.
std::array<dvec3, 2> axesAcross(const dvec3& direction) {
    const dvec3 magnitude = glm::abs(direction);
    dvec3 least(0.0);
    least[magnitude.x < magnitude.y && magnitude.x < magnitude.z ? 0 : (magnitude.y <= magnitude.z ? 1 : 2)] = 1.0;
    const dvec3 u = glm::normalize(least - direction * glm::dot(least, direction));
    return {u, glm::cross(direction, u)};
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
    GridBuilder(const Lattice& lattice, double maxSide, double splitShare)
        : lattice_(lattice), maxSide_(maxSide), splitShare_(splitShare) {}

    void add(const DirectionalLight& light) {
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
        grids_.emitted += light.irradiance * projectedArea(lattice_, direction);
        push({frame});
    }

    void add(const PointLight& light) {
        const dvec3 nearest = glm::clamp(light.position, lattice_.min, lattice_.max());
        const double distance = glm::distance(nearest, light.position);
        const dvec3 axis = lattice_.min + 0.5 * lattice_.extent() - light.position;
        grids_.emitted += light.power;
        const bool distant = distance > 0.0 && seenInWindow(light.position, axis);
        push(distant ? std::vector{windowFrame(light, axis, distance)} : cubeFrames(light, distance));
    }

    LaunchGrids take() { return std::move(grids_); }

private:
    bool seenInWindow(const dvec3& position, const dvec3& axis) const {
        const auto corners = cornersOf(lattice_);
        return std::all_of(corners.begin(), corners.end(), [&](const dvec3& corner) {
            const dvec3 towards = corner - position;
            return glm::dot(towards, axis) > kMinWindowCosine * glm::length(towards) * glm::length(axis);
        });
    }

    /// One grid on the plane through the domain's centre, as wide as the domain's shadow on it.
    LaunchFrame windowFrame(const PointLight& light, const dvec3& axis, double distance) const {
        const double axisLength = glm::length(axis);
        const dvec3 direction = axis / axisLength;
        const auto [u, v] = axesAcross(direction);
        double halfU = 0.0, halfV = 0.0;
        for (const dvec3& corner : cornersOf(lattice_)) {
            const dvec3 towards = corner - light.position;
            const dvec3 onPlane = towards * (axisLength / glm::dot(towards, direction)) - axis;
            halfU = std::max(halfU, std::abs(glm::dot(onPlane, u)));
            halfV = std::max(halfV, std::abs(glm::dot(onPlane, v)));
        }
        LaunchFrame frame = pointFrame(light, axis, distance);
        placeAxes(frame, u * halfU, v * halfV);
        return frame;
    }

    /// Six faces of a cube about the light.
    std::vector<LaunchFrame> cubeFrames(const PointLight& light, double distance) const {
        std::vector<LaunchFrame> frames;
        const double half = lattice_.voxel;
        for (int face = 0; face < 6; ++face) {
            dvec3 axis(0.0), u(0.0), v(0.0);
            axis[face / 2] = face % 2 == 0 ? half : -half;
            u[(face / 2 + 1) % 3] = half;
            v[(face / 2 + 2) % 3] = half;
            LaunchFrame frame = pointFrame(light, axis, distance);
            frame.a = u;
            frame.b = v;
            frame.cellsU = frame.cellsV = distance > 0.0 ? kCloseCells : kNearCells;
            frames.push_back(frame);
        }
        return frames;
    }

    LaunchFrame pointFrame(const PointLight& light, const dvec3& axis, double distance) const {
        LaunchFrame frame{};
        frame.isPoint = 1u;
        frame.origin = light.position;
        frame.axis = axis;
        frame.centre = light.position + axis;
        frame.phase = float(glm::length(axis) - distance);
        frame.strength = light.power / (4.0 * std::numbers::pi);
        return frame;
    }

    void placeAxes(LaunchFrame& frame, const dvec3& a, const dvec3& b) const {
        frame.a = a;
        frame.b = b;
        frame.cellsU = cellsAlong(2.0 * glm::length(a), maxSide_);
        frame.cellsV = cellsAlong(2.0 * glm::length(b), maxSide_);
    }

    /// A point light's frame is densest where its axis meets it.
    static double cellPowerBound(const LaunchFrame& frame) {
        const double area = 4.0 * double(glm::length(glm::cross(frame.a, frame.b))) / double(frame.cellsU * frame.cellsV);
        const double distance2 = frame.isPoint != 0u ? double(glm::dot(frame.axis, frame.axis)) : 1.0;
        return strongestOf(frame.strength) * area / distance2;
    }

    /// The frames of one light.
    void push(const std::vector<LaunchFrame>& frames) {
        double launched = 0.0;
        for (const LaunchFrame& frame : frames) {
            grids_.strongestCellPower = std::max(grids_.strongestCellPower, cellPowerBound(frame));
            launched += cellPowerBound(frame) * frame.cellsU * frame.cellsV;
        }
        for (LaunchFrame frame : frames) {
            frame.splitPower = float(splitShare_ * launched);
            frame.firstCell = grids_.cellCount;
            grids_.cellCount += frame.cellsU * frame.cellsV;
            grids_.frames.push_back(frame);
        }
        grids_.strongestPower += launched;
    }

    const Lattice& lattice_;
    double maxSide_;
    double splitShare_;
    LaunchGrids grids_;
};

} // namespace

LaunchGrids launchGrids(const std::vector<Light>& lights, const Lattice& lattice, double maxSide, double splitShare) {
    GridBuilder builder(lattice, maxSide, splitShare);
    for (const Light& light : lights) {
        std::visit([&](const auto& one) { builder.add(one); }, light);
    }
    return builder.take();
}

} // namespace eikonal::bake

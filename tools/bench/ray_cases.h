#pragma once
// Beams of rays through fields with a closed form, and where they leave the box, in which direction, after what optical path.

#include <functional>
#include <string>
#include <vector>

#include "common/reference/reference_field.h"

namespace eikonal::bench {

/// A ray that stands on the box's face or in it; direction unit.
struct RayStart {
    glm::dvec3 x{0.0}, direction{0.0};
};

struct RayEnd {
    glm::dvec3 x{0.0}, direction{0.0};
    double opticalLength = 0.0;  ///< from the start [scene units]
};

struct RayCase {
    std::string name;
    std::function<reference::Optics(const glm::dvec3&)> optics;
    std::vector<RayStart> starts;
    std::vector<RayEnd> truth;
};

/// Half the edge of the box about the origin in which rays are followed, and of the one that voxels fill: no ray meets the
/// outermost ones, where interpolation has neighbours on one side only [scene units].
inline constexpr double kHalfBox = 1.0, kHalfLattice = 1.125;

/// Luneburg from the lens's surface to its focus, fish-eye, graded rod, sech profile: exact. The smoothed sphere by the
/// fourth-order integrator at 1/200 of the width of its boundary, below 1e-9. `rays` in each.
std::vector<RayCase> rayCases(int rays);

} // namespace eikonal::bench

#pragma once
// Index fields with a closed form of n and its gradient, for which rays are known (docs/physics.md, section 6).

#include <algorithm>
#include <cmath>

#include "common/reference/reference_field.h"

namespace eikonal::bench {

using reference::Optics;

/// Luneburg's lens of radius 1, n² = 2 - r², continued beyond its surface, so that voxels there know no kink.
struct Luneburg {
    Optics optics(const glm::dvec3& x) const {
        const double square = 2.0 - glm::dot(x, x), n = std::sqrt(std::max(square, 0.25));
        return {n, square > 0.25 ? -x / n : glm::dvec3(0.0)};
    }
};

/// Maxwell's fish-eye n0/(1 + r²).
struct FishEye {
    double n0 = 2.0;

    Optics optics(const glm::dvec3& x) const {
        const double n = n0 / (1.0 + glm::dot(x, x));
        return {n, x * (-2.0 * n * n / n0)};
    }
};

/// A rod along z with n² = n0² (1 - g² ρ²), for ρ g < 1.
struct GradedRod {
    double n0 = 1.8, g = 0.8;

    Optics optics(const glm::dvec3& x) const {
        const glm::dvec3 across(x.x, x.y, 0.0);
        const double n = n0 * std::sqrt(std::max(1.0 - g * g * glm::dot(across, across), 0.05));
        return {n, across * (-n0 * n0 * g * g / n)};
    }
};

/// n0 sech(g x), layered across x.
struct SechProfile {
    double n0 = 1.6, g = 1.4;

    Optics optics(const glm::dvec3& x) const {
        const double n = n0 / std::cosh(g * x.x);
        return {n, {-g * std::tanh(g * x.x) * n, 0.0, 0.0}};
    }
};

} // namespace eikonal::bench

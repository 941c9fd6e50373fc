#pragma once
// Lights that start at a point, or at many, with the intensity that each launches by direction.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "common/scene.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal::bake {

/// Two unit vectors across `direction`, which is their cross product: coordinate axes where it is one.
std::array<glm::dvec3, 2> axesAcross(const glm::dvec3& direction);

/// A point that launches `intensity` times a profile of the angle to its axis (shaders/physics/profile.glsl).
struct PointSource {
    glm::dvec3 position;
    glm::dvec3 intensity;  ///< greatest [power per steradian]
    std::uint32_t profile = PROFILE_NONE;
    glm::dvec3 axis{1.0, 0.0, 0.0};  ///< unit
    double coneInner = 0.0, coneOuter = 0.0;  ///< versines, of a cone only

    /// The profile in a direction, which need not be of unit length.
    double shareAlong(const glm::dvec3& direction) const;
};

PointSource pointSourceOf(const PointLight& light);
PointSource pointSourceOf(const SpotLight& light);

/// Equal strata of the rectangle, as near to squares as its shape allows, a source in the centre of each; they share its
/// power.
std::vector<PointSource> pointSourcesOf(const RectangleLight& light);

} // namespace eikonal::bake

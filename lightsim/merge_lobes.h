#pragma once
// Light from many directions as a few lobes.

#include <vector>

#include <glm/glm.hpp>

#include "common/baked_light.h"

namespace eikonal::bake {

/// Light from about one direction, before it is rounded to what a bake stores.
struct DirectedLight {
    glm::dvec3 irradiance{0.0};  ///< per band [any unit]
    glm::dvec3 flux{0.0};        ///< flux vector, summed over bands [the same unit]

    double power() const { return irradiance.x + irradiance.y + irradiance.z; }
    DirectedLight& operator+=(const DirectedLight& other);
};

/// The lobe as directed light.
DirectedLight directedLight(const LightLobe& lobe);
DirectedLight directedLight(const glm::vec3& irradiance, const glm::vec3& direction);

/// Merges what loses least of Σ|F| again and again: until at most kMostLobes are left, and on while a merger loses less than
/// `tolerance` of the whole power. Strongest first. The same light in the same order gives the same lobes; takes time as the
/// square of its number.
std::vector<DirectedLight> mergedLobes(std::vector<DirectedLight> light, double tolerance);

/// The lobes, at most kMostLobes, scaled and turned by what they miss of a voxel's light as its grids hold it.
VoxelLobes lobesOfVoxel(std::vector<DirectedLight> lobes, const glm::vec3& irradiance, const glm::vec3& direction);

} // namespace eikonal::bake

#pragma once
// Positions on the device are counted from the middle of the domain, so that single precision serves wherever it lies.

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal {

inline glm::dvec3 middleOf(const Lattice& domain) { return domain.min + 0.5 * domain.extent(); }

inline glm::dvec3 deviceFromWorld(const Lattice& domain, const glm::dvec3& world) { return world - middleOf(domain); }

inline glm::dvec3 worldFromDevice(const Lattice& domain, const glm::dvec3& position) { return position + middleOf(domain); }

inline Camera deviceFromWorld(const Lattice& domain, Camera camera) {
    camera.position = deviceFromWorld(domain, camera.position);
    camera.lookAt = deviceFromWorld(domain, camera.lookAt);
    return camera;
}

} // namespace eikonal

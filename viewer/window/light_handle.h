#pragma once
// The handle that a light is moved by in the view: pure geometry from pointer to light.

#include <optional>

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal::window {

/// Where a light's handle stands: at its position; of a beam, where it comes from, on a sphere around the domain.
glm::dvec3 handlePosition(const Light& light, const Lattice& domain);

/// Where handles may stand, in shares of the picture: what panels leave of it.
struct HandleRoom {
    double aspect = 1.0;                   ///< of the picture, width over height
    glm::dvec2 lowest{0.03}, highest{0.97};
    glm::dvec2 numbers{0.0};               ///< lower right corner of what is covered from the picture's upper left corner on
};

/// Where the handle is drawn, (0, 0) to (1, 1) over the picture; at the edge of the room for one beyond. None for one behind the
/// camera.
std::optional<glm::dvec2> handleOnScreen(const Light& light, const Lattice& domain, const Camera& camera,
                                         const HandleRoom& room);

/// The light with its handle under the pointer. A position moves at its distance from the camera; a beam's handle stays on
/// its sphere, on the half that faces the camera and, beyond its outline, on the outline. It stands still in time then.
Light draggedTo(const Light& light, const Lattice& domain, const Camera& camera, const glm::dvec2& at, double aspect);

/// The light whose handle is within `reach` (share of the picture's height) of the pointer, the nearest one.
std::optional<std::size_t> handleUnder(const Scene& scene, const Lattice& domain, const Camera& camera,
                                       const glm::dvec2& at, const HandleRoom& room, double reach);

} // namespace eikonal::window

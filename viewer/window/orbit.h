#pragma once
// Camera moves: pure functions from camera to camera. Angles in radians, lengths in scene units.

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal::window {

/// Turns the camera about what it looks at: by `angles.x` about its up vector, by `angles.y` towards it. It stops a little
/// short of the poles, where the picture would flip.
Camera orbited(const Camera& camera, const glm::dvec2& angles);

/// Moves camera and target across the view so that what is at the target's distance follows a pointer that moved by
/// `shift`, in heights of the picture, x to the right, y down.
Camera panned(const Camera& camera, const glm::dvec2& shift);

/// Moves the camera towards what it looks at, a tenth of the distance a notch; negative: away.
Camera dollied(const Camera& camera, double notches);

/// Moves camera and target by shares of their distance: x to the right, y up, z forward.
Camera flown(const Camera& camera, const glm::dvec3& shares);

/// Keeps the direction and stands where the box just fits the picture. `aspect`: width over height.
Camera framing(const Camera& camera, const Lattice& box, double aspect);

/// Looks along an axis (0, 1, 2: x, y, z) from its positive side at the same distance.
Camera alongAxis(const Camera& camera, int axis);

/// A pixel's view ray, not normalised: `at` is (0, 0) in the picture's upper left corner, (1, 1) in its lower right.
glm::dvec3 rayThrough(const Camera& camera, const glm::dvec2& at, double aspect);

/// Where a point appears, in the same coordinates; `depth` along the view, not positive behind the camera.
struct Projected {
    glm::dvec2 at{0.0};
    double depth = 0.0;
};
Projected projected(const Camera& camera, const glm::dvec3& point, double aspect);

} // namespace eikonal::window

#include "viewer/window/orbit.h"

#include <algorithm>
#include <cmath>

namespace eikonal::window {

namespace {

constexpr double kNearestPole = 0.02;  // radians between the view and the up vector
constexpr double kNotch = 0.9;         // of the distance that a notch leaves
constexpr double kNearest = 1e-6;      // of the distance to a target, in scene units

/// Orthonormal frame of a camera.
struct Frame {
    glm::dvec3 right, up, forward;
};

Frame frameOf(const Camera& camera) {
    Frame frame;
    frame.forward = glm::normalize(camera.lookAt - camera.position);
    frame.right = glm::normalize(glm::cross(frame.forward, camera.up));
    frame.up = glm::cross(frame.right, frame.forward);
    return frame;
}

double distanceOf(const Camera& camera) { return glm::length(camera.lookAt - camera.position); }

double halfHeight(const Camera& camera) { return std::tan(glm::radians(camera.fov) / 2.0); }

/// Rodrigues' rotation of v about a unit axis.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * (glm::dot(axis, v) * (1.0 - std::cos(angle)));
}

Camera moved(Camera camera, const glm::dvec3& by) {
    camera.position += by;
    camera.lookAt += by;
    return camera;
}

} // namespace

Camera orbited(const Camera& camera, const glm::dvec2& angles) {
    const glm::dvec3 up = glm::normalize(camera.up);
    const glm::dvec3 offset = turned(camera.position - camera.lookAt, up, angles.x);
    const double polar = std::acos(std::clamp(glm::dot(glm::normalize(offset), up), -1.0, 1.0));
    const double wanted = std::clamp(polar - angles.y, std::min(kNearestPole, polar),
                                     std::max(3.14159265358979323846 - kNearestPole, polar));
    Camera result = camera;
    result.position = camera.lookAt + turned(offset, glm::normalize(glm::cross(up, offset)), wanted - polar);
    return result;
}

Camera panned(const Camera& camera, const glm::dvec2& shift) {
    const Frame frame = frameOf(camera);
    const double height = 2.0 * halfHeight(camera) * distanceOf(camera);
    return moved(camera, height * (frame.up * shift.y - frame.right * shift.x));
}

Camera dollied(const Camera& camera, double notches) {
    Camera result = camera;
    const double distance = std::max(distanceOf(camera) * std::pow(kNotch, notches), kNearest);
    result.position = camera.lookAt - frameOf(camera).forward * distance;
    return result;
}

Camera flown(const Camera& camera, const glm::dvec3& shares) {
    const Frame frame = frameOf(camera);
    return moved(camera, distanceOf(camera) * (frame.right * shares.x + frame.up * shares.y + frame.forward * shares.z));
}

Camera framing(const Camera& camera, const Lattice& box, double aspect) {
    const glm::dvec3 forward = frameOf(camera).forward;
    const double half = std::atan(halfHeight(camera) * std::min(aspect, 1.0));
    Camera result = camera;
    result.lookAt = 0.5 * (box.min + box.max());
    result.position = result.lookAt - forward * (0.5 * glm::length(box.extent()) / std::sin(half));
    return result;
}

Camera alongAxis(const Camera& camera, int axis) {
    Camera result = camera;
    glm::dvec3 towards(0.0);
    towards[axis] = distanceOf(camera);
    result.position = camera.lookAt + towards;
    result.up = axis == 1 ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    return result;
}

glm::dvec3 rayThrough(const Camera& camera, const glm::dvec2& at, double aspect) {
    const Frame frame = frameOf(camera);
    const glm::dvec2 screen = (2.0 * at - 1.0) * halfHeight(camera);
    return frame.forward + frame.right * (screen.x * aspect) - frame.up * screen.y;
}

Projected projected(const Camera& camera, const glm::dvec3& point, double aspect) {
    const Frame frame = frameOf(camera);
    const glm::dvec3 offset = point - camera.position;
    const double depth = glm::dot(offset, frame.forward);
    const double scale = 1.0 / (halfHeight(camera) * depth);
    const glm::dvec2 screen(glm::dot(offset, frame.right) * scale / aspect, -glm::dot(offset, frame.up) * scale);
    return {0.5 * (screen + 1.0), depth};
}

} // namespace eikonal::window

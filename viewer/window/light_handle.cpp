#include "viewer/window/light_handle.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "common/light_motion.h"
#include "viewer/window/orbit.h"

namespace eikonal::window {

namespace {

constexpr double kSphereShare = 0.45;  // of the domain's diagonal: inside the picture that frames the domain

glm::dvec3 centerOf(const Lattice& domain) { return 0.5 * (domain.min + domain.max()); }

double sphereRadius(const Lattice& domain) { return kSphereShare * glm::length(domain.extent()); }

/// Where a ray meets a sphere first, or the point of the sphere nearest to it.
glm::dvec3 onSphere(const glm::dvec3& origin, const glm::dvec3& ray, const glm::dvec3& center, double radius) {
    const glm::dvec3 unit = glm::normalize(ray);
    const double along = glm::dot(center - origin, unit);
    const glm::dvec3 nearest = origin + along * unit;
    const double away = glm::length(nearest - center);
    if (away >= radius) return center + (nearest - center) * (radius / away);
    return nearest - std::sqrt(radius * radius - away * away) * unit;
}

/// The nearest place beside them, where there is one.
glm::dvec2 besideNumbers(glm::dvec2 at, const HandleRoom& room) {
    const glm::dvec2 way = (room.numbers - at) * glm::dvec2(room.aspect, 1.0);
    if (way.x <= 0.0 || way.y <= 0.0) return at;
    const bool isRoomAtTheRight = room.numbers.x < room.highest.x, isRoomBelow = room.numbers.y < room.highest.y;
    if (isRoomBelow && (way.y <= way.x || !isRoomAtTheRight)) {
        at.y = room.numbers.y;
    } else if (isRoomAtTheRight) {
        at.x = room.numbers.x;
    }
    return at;
}

} // namespace

glm::dvec3 handlePosition(const Light& light, const Lattice& domain) {
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.position; }) {
                return kind.position;
            } else {
                return centerOf(domain) - kind.direction * sphereRadius(domain);
            }
        },
        light);
}

std::optional<glm::dvec2> handleOnScreen(const Light& light, const Lattice& domain, const Camera& camera,
                                         const HandleRoom& room) {
    const Projected handle = projected(camera, handlePosition(light, domain), room.aspect);
    if (handle.depth <= 0.0) return std::nullopt;
    return besideNumbers(glm::clamp(handle.at, room.lowest, room.highest), room);
}

Light draggedTo(const Light& light, const Lattice& domain, const Camera& camera, const glm::dvec2& at, double aspect) {
    const glm::dvec3 ray = rayThrough(camera, at, aspect);
    const double depth = projected(camera, handlePosition(light, domain), aspect).depth;
    Light moved = light;
    keyframesOf(moved).clear();
    std::visit(
        [&](auto& kind) {
            if constexpr (requires { kind.position; }) {
                kind.position = camera.position + ray * depth;  // the ray advances by one along the view
            } else {
                const glm::dvec3 center = centerOf(domain);
                kind.direction = glm::normalize(center - onSphere(camera.position, ray, center, sphereRadius(domain)));
            }
        },
        moved);
    return moved;
}

std::optional<std::size_t> handleUnder(const Scene& scene, const Lattice& domain, const Camera& camera,
                                       const glm::dvec2& at, const HandleRoom& room, double reach) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto handle = handleOnScreen(scene.lights[i], domain, camera, room);
        if (!handle) continue;
        const double distance = glm::length((*handle - at) * glm::dvec2(room.aspect, 1.0));
        if (distance < reach) {
            reach = distance;
            nearest = i;
        }
    }
    return nearest;
}

} // namespace eikonal::window

#include "lightsim/point_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/physics.h"

namespace eikonal::bake {

namespace {

using glm::dvec3;

constexpr double kSphere = 4.0 * std::numbers::pi;  // [sr]

/// Unit vectors along a rectangle's width and height.
std::array<dvec3, 2> sidesOf(const RectangleLight& light) {
    const dvec3 upAcross = light.up - light.direction * glm::dot(light.up, light.direction);
    if (glm::length(upAcross) < 1e-6) {
        return axesAcross(light.direction);
    }
    const dvec3 height = glm::normalize(upAcross);
    return {glm::cross(height, light.direction), height};
}

/// Columns and rows of at most `samples` strata.
glm::ivec2 strataOf(const RectangleLight& light) {
    const double columns = std::round(std::sqrt(light.samples * light.size.x / light.size.y));
    const int x = int(std::clamp(columns, 1.0, double(light.samples)));
    return {x, std::max(1, light.samples / x)};
}

} // namespace

std::array<dvec3, 2> axesAcross(const dvec3& direction) {
    const dvec3 magnitude = glm::abs(direction);
    dvec3 least(0.0);
    least[magnitude.x < magnitude.y && magnitude.x < magnitude.z ? 0 : (magnitude.y <= magnitude.z ? 1 : 2)] = 1.0;
    const dvec3 u = glm::normalize(least - direction * glm::dot(least, direction));
    return {u, glm::cross(direction, u)};
}

double PointSource::shareAlong(const dvec3& direction) const {
    switch (profile) {
    case PROFILE_CONE: return f64::coneShare(glm::normalize(direction), axis, coneInner, coneOuter);
    case PROFILE_COSINE: return f64::cosineShare(glm::normalize(direction), axis);
    default: return 1.0;
    }
}

PointSource pointSourceOf(const PointLight& light) { return {light.position, light.power / kSphere}; }

PointSource pointSourceOf(const SpotLight& light) {
    const double half = glm::radians(0.5 * light.angle);
    const double inner = f64::versineOfAngle(half * (1.0 - light.blend));
    const double outer = f64::versineOfAngle(half);
    const dvec3 intensity = light.power / (kSphere * f64::coneMeanShare(inner, outer));
    return {light.position, intensity, PROFILE_CONE, light.direction, inner, outer};
}

std::vector<PointSource> pointSourcesOf(const RectangleLight& light) {
    const glm::ivec2 strata = strataOf(light);
    const auto [width, height] = sidesOf(light);
    const dvec3 intensity = light.power / (kSphere * f64::cosineMeanShare() * double(strata.x * strata.y));
    std::vector<PointSource> sources;
    for (int y = 0; y < strata.y; ++y) {
        for (int x = 0; x < strata.x; ++x) {
            const glm::dvec2 place = ((glm::dvec2(x, y) + 0.5) / glm::dvec2(strata) - 0.5) * light.size;
            sources.push_back({light.position + width * place.x + height * place.y, intensity, PROFILE_COSINE,
                               light.direction});
        }
    }
    return sources;
}

} // namespace eikonal::bake

#include "common/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/physics.h"

namespace eikonal {

namespace {

constexpr glm::ivec2 kGradientCells{256, 128};  // of the sphere; integrals are good to 1e-4 of themselves

} // namespace

std::optional<Image> environmentImage(const Scene& scene) {
    if (!scene.environment.image) {
        return std::nullopt;
    }
    return readImage(scene.resolve(*scene.environment.image));
}

EnvironmentCells::EnvironmentCells(const Environment& environment, const Image* image, int maxRows)
    : environment_(environment), image_(image), size_(kGradientCells) {
    if (image) {
        const int stride = std::max(1, image->size.y / maxRows);
        size_ = glm::max(image->size / stride, glm::ivec2(1));
    }
}

glm::dvec3 EnvironmentCells::direction(int x, int y) const {
    const glm::dvec3 own = f64::directionFromLatLong(centreOf(x, y));
    return image_ ? f64::turnedAboutY(own, -glm::radians(environment_.rotate)) : own;
}

glm::dvec3 EnvironmentCells::radiance(int x, int y) const {
    if (!image_) {
        return environment_.intensity *
               f64::gradientRadiance(direction(x, y), environment_.gradient[0], environment_.gradient[1]);
    }
    const glm::ivec2 pixel = glm::min(glm::ivec2(centreOf(x, y) * glm::dvec2(image_->size)), image_->size - 1);
    return environment_.intensity * glm::dvec3(image_->at(pixel.x, pixel.y));
}

double EnvironmentCells::solidAngle(int y) const {
    const double rowAngle = std::numbers::pi / size_.y;
    const double band = std::cos(y * rowAngle) - std::cos((y + 1) * rowAngle);
    return band * 2.0 * std::numbers::pi / size_.x;
}

} // namespace eikonal

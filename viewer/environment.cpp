#include "viewer/environment.h"

#include <algorithm>
#include <cmath>

#include "common/physics.h"

namespace eikonal::viewer {

namespace {

constexpr glm::ivec2 kGradientCells{256, 128};  // of the sphere; the means are good to 1e-4 of themselves
constexpr int kAmbientRows = 256;             // a larger map is looked at in every so many rows and columns

/// Cosine-weighted mean of a radiance over the hemispheres about +X, -X, +Y, -Y, +Z, -Z, in the map's own frame.
template <class Radiance>
std::array<glm::vec3, 6> hemisphereMeans(const glm::ivec2& cells, const Radiance& radianceOf, double angle) {
    std::array<glm::dvec3, 6> sum{};
    std::array<double, 6> weight{};
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            const glm::dvec2 uv((x + 0.5) / cells.x, (y + 0.5) / cells.y);
            const glm::dvec3 own = f64::directionFromLatLong(uv);
            const glm::dvec3 direction = f64::turnedAboutY(own, -angle);
            const double solidAngle = std::sqrt(std::max(0.0, 1.0 - own.y * own.y));
            const glm::dvec3 radiance = radianceOf(uv, direction);
            for (std::size_t face = 0; face < 6; ++face) {
                const double along = direction[int(face / 2)] * (face % 2 == 0 ? 1.0 : -1.0);
                if (along <= 0.0) continue;
                sum[face] += radiance * (along * solidAngle);
                weight[face] += along * solidAngle;
            }
        }
    }
    std::array<glm::vec3, 6> means{};
    for (std::size_t face = 0; face < 6; ++face) means[face] = glm::vec3(sum[face] / weight[face]);
    return means;
}

std::array<glm::vec3, 6> ambientOfMap(const Image& map, const Environment& environment, double angle) {
    const int stride = std::max(1, map.size.y / kAmbientRows);
    const glm::ivec2 cells = glm::max(map.size / stride, glm::ivec2(1));
    const auto radiance = [&](const glm::dvec2& uv, const glm::dvec3&) {
        const glm::ivec2 pixel = glm::min(glm::ivec2(uv * glm::dvec2(map.size)), map.size - 1);
        return glm::dvec3(map.at(pixel.x, pixel.y)) * environment.intensity;
    };
    return hemisphereMeans(cells, radiance, angle);
}

std::array<glm::vec3, 6> ambientOfGradient(const Environment& environment) {
    const auto radiance = [&](const glm::dvec2&, const glm::dvec3& direction) {
        return f64::gradientRadiance(direction, environment.gradient[0], environment.gradient[1]) * environment.intensity;
    };
    return hemisphereMeans(kGradientCells, radiance, 0.0);
}

gpu::Texture2D mapTexture(const gpu::Context& context, const Image& map) {
    gpu::Texture2D texture(context, gpu::TexelFormat::kRgba32f, map.size, "environment");
    std::vector<glm::vec4> texels(map.pixels.size());
    std::transform(map.pixels.begin(), map.pixels.end(), texels.begin(),
                   [](const glm::vec3& pixel) { return glm::vec4(pixel, 1.0f); });
    texture.upload(texels.data());
    return texture;
}

} // namespace

EnvironmentLight::EnvironmentLight(const gpu::Context& context, const Environment& environment, const Image* map,
                                   bool ambient)
    : environment_(environment) {
    if (map) map_.emplace(mapTexture(context, *map));
    if (!ambient) return;
    ambient_ = map ? ambientOfMap(*map, environment, glm::radians(environment.rotate)) : ambientOfGradient(environment);
}

void EnvironmentLight::configure(gpu::ViewBlock& view) const {
    view.environmentAngle = float(glm::radians(environment_.rotate));
    view.environmentScale = float(environment_.intensity);
    view.horizon = glm::vec3(environment_.gradient[0] * environment_.intensity);
    view.zenith = glm::vec3(environment_.gradient[1] * environment_.intensity);
    for (std::size_t i = 0; i < ambient_.size(); ++i) view.ambient[i] = glm::vec4(ambient_[i], 0.0f);
}

void EnvironmentLight::bind() const {
    if (map_) map_->bind(gpu::kUnitEnvironment);
}

std::vector<std::string> EnvironmentLight::defines() const {
    return map_ ? std::vector<std::string>{"ENVIRONMENT_IMAGE"} : std::vector<std::string>{};
}

std::vector<std::pair<std::string, std::size_t>> EnvironmentLight::textures() const {
    if (!map_) return {};
    return {{map_->label(), map_->bytes()}};
}

} // namespace eikonal::viewer

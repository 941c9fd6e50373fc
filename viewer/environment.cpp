#include "viewer/environment.h"

#include <algorithm>

#include "common/environment_map.h"

namespace eikonal::viewer {

namespace {

constexpr int kAmbientRows = 256;  // a larger map is looked at in every so many rows and columns

/// Cosine-weighted mean of radiance over the hemispheres about +X, -X, +Y, -Y, +Z, -Z.
std::array<glm::vec3, 6> hemisphereMeans(const EnvironmentCells& cells) {
    std::array<glm::dvec3, 6> sum{};
    std::array<double, 6> weight{};
    for (int y = 0; y < cells.size().y; ++y) {
        const double solidAngle = cells.solidAngle(y);
        for (int x = 0; x < cells.size().x; ++x) {
            const glm::dvec3 direction = cells.direction(x, y);
            const glm::dvec3 radiance = cells.radiance(x, y);
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

gpu::Texture2D mapTexture(const gpu::Context& context, const Image& map, bool means) {
    gpu::Texture2D texture(context, gpu::TexelFormat::kRgba32f, map.size, "environment", means);
    std::vector<glm::vec4> texels(map.pixels.size());
    std::transform(map.pixels.begin(), map.pixels.end(), texels.begin(),
                   [](const glm::vec3& pixel) { return glm::vec4(pixel, 1.0f); });
    texture.upload(texels.data());
    if (means) texture.fillMeans();
    return texture;
}

} // namespace

EnvironmentLight::EnvironmentLight(const gpu::Context& context, const Environment& environment, const Image* map,
                                   bool ambient, bool means)
    : environment_(environment) {
    if (map) map_.emplace(mapTexture(context, *map, means));
    if (ambient) ambient_ = hemisphereMeans(EnvironmentCells(environment, map, kAmbientRows));
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

#include "viewer/light.h"

#include <cmath>

#include "common/gpu_fields.h"

namespace eikonal::viewer {

namespace {

/// 1 + row of each voxel, 0 without; exact in a float below 2^24 rows, more than a texture holds.
DenseGrid<float> rowsAfter(const LobeTable& lobes, const glm::ivec3& size) {
    if (lobes.empty()) return {};
    DenseGrid<float> rows(size, 0.0f);
    for (std::size_t row = 0; row < lobes.voxels.size(); ++row) rows.values[lobes.voxels[row]] = float(row + 1);
    return rows;
}

std::optional<gpu::Texture2D> lobeTexture(const gpu::Context& context, const LobeTable& lobes) {
    if (lobes.empty()) return std::nullopt;
    static_assert(kMostLobes == gpu::kLobesPerRow);
    const std::size_t rowsAcross = gpu::kLobeRowsAcross;
    const std::size_t height = (lobes.rows.size() + rowsAcross - 1) / rowsAcross;
    const glm::ivec2 size(gpu::kLobeRowsAcross * gpu::kLobesPerRow * gpu::kTexelsPerLobe, int(height));
    gpu::Texture2D texture(context, gpu::TexelFormat::kRgba32f, size, "lobes");
    std::vector<glm::vec4> texels;
    for (const VoxelLobes& row : lobes.rows) {
        for (const LightLobe& lobe : row) {
            texels.emplace_back(lobe.irradiance, 0.0f);
            texels.emplace_back(lobe.direction, 0.0f);
        }
    }
    texels.resize(std::size_t(size.x) * std::size_t(size.y), glm::vec4(0.0f));
    texture.upload(texels.data());
    return texture;
}

std::string bandName(const BandIrradiance& band) { return "irradiance_" + std::to_string(std::lround(band.wavelengthNm)) + "nm"; }

gpu::Texture3D bandTexture(const gpu::Context& context, const BandIrradiance& band) {
    gpu::Texture3D texture(context, gpu::TexelFormat::kR32f, band.irradiance.size, bandName(band));
    texture.upload(band.irradiance.values.data());
    texture.showGrey();
    return texture;
}

} // namespace

Light::Light(const gpu::Context& context, const BakedLight* bake, std::size_t bandCount) {
    if (!bake) return;
    textures_.emplace(Textures{
        bake->lattice, colourTexture(context, bake->irradiance, {}, "irradiance"),
        colourTexture(context, bake->lightDirection, rowsAfter(bake->lobes, bake->lattice.size), "light_direction"),
        lobeTexture(context, bake->lobes), {}});
    if (bake->bands.size() != bandCount) return;
    for (const BandIrradiance& band : bake->bands) textures_->bands.push_back(bandTexture(context, band));
}

void Light::configure(gpu::ViewBlock& view) const {
    if (!textures_) return;
    view.lightScale = glm::vec3(1.0 / textures_->lattice.extent());
    view.opaqueOffset = float(textures_->lattice.voxel);
}

void Light::bind() const {
    if (!textures_) return;
    textures_->irradiance.bind(gpu::kUnitIrradiance);
    textures_->direction.bind(gpu::kUnitLightDirection);
    if (textures_->lobes) textures_->lobes->bind(gpu::kUnitLobes);
}

void Light::bindBand(std::size_t band) const {
    if (isByBand()) textures_->bands[band].bind(gpu::kUnitIrradiance);
}

std::vector<std::string> Light::defines() const {
    if (!textures_) return {};
    if (!textures_->lobes) return {"BAKED_LIGHT"};
    return {"BAKED_LIGHT", "LIGHT_LOBES"};
}

std::vector<std::pair<std::string, std::size_t>> Light::textures() const {
    if (!textures_) return {};
    std::vector<std::pair<std::string, std::size_t>> rows{
        {textures_->irradiance.label(), textures_->irradiance.bytes()},
        {textures_->direction.label(), textures_->direction.bytes()}};
    if (textures_->lobes) rows.emplace_back(textures_->lobes->label(), textures_->lobes->bytes());
    for (const gpu::Texture3D& band : textures_->bands) rows.emplace_back(band.label(), band.bytes());
    return rows;
}

} // namespace eikonal::viewer

#include "viewer/light.h"

#include <cmath>

#include "common/gpu_fields.h"

namespace eikonal::viewer {

namespace {

std::string bandName(const BandIrradiance& band) { return "irradiance_" + std::to_string(std::lround(band.wavelengthNm)) + "nm"; }

gpu::Texture3D bandTexture(const gpu::Context& context, const BandIrradiance& band) {
    gpu::Texture3D texture(context, gpu::TexelFormat::kR32f, band.irradiance.size, bandName(band));
    texture.upload(band.irradiance.values.data());
    texture.showRedInAllChannels();
    return texture;
}

} // namespace

Light::Light(const gpu::Context& context, const BakedLight* bake, std::size_t bandCount) {
    if (!bake) return;
    textures_.emplace(Textures{bake->lattice, colourTexture(context, bake->irradiance, {}, "irradiance"),
                               colourTexture(context, bake->lightDirection, {}, "light_direction"), {}});
    if (bake->bands.size() != bandCount) return;
    for (const BandIrradiance& band : bake->bands) textures_->bands.push_back(bandTexture(context, band));
}

void Light::configure(gpu::ViewBlock& view) const {
    if (!textures_) return;
    view.lightMin = glm::vec3(textures_->lattice.min);
    view.lightScale = glm::vec3(1.0 / textures_->lattice.extent());
    view.opaqueOffset = float(textures_->lattice.voxel);
}

void Light::bind() const {
    if (!textures_) return;
    textures_->irradiance.bind(gpu::kUnitIrradiance);
    textures_->direction.bind(gpu::kUnitLightDirection);
}

void Light::bindBand(std::size_t band) const {
    if (isByBand()) textures_->bands[band].bind(gpu::kUnitIrradiance);
}

std::vector<std::string> Light::defines() const {
    return textures_ ? std::vector<std::string>{"BAKED_LIGHT"} : std::vector<std::string>{};
}

std::vector<std::pair<std::string, std::size_t>> Light::textures() const {
    if (!textures_) return {};
    std::vector<std::pair<std::string, std::size_t>> rows{
        {textures_->irradiance.label(), textures_->irradiance.bytes()},
        {textures_->direction.label(), textures_->direction.bytes()}};
    for (const gpu::Texture3D& band : textures_->bands) rows.emplace_back(band.label(), band.bytes());
    return rows;
}

} // namespace eikonal::viewer

#include "viewer/light.h"

#include "common/gpu_fields.h"

namespace eikonal::viewer {

Light::Light(const gpu::Context& context, const BakedLight* bake) {
    if (!bake) return;
    textures_.emplace(Textures{bake->lattice, colourTexture(context, bake->irradiance, {}, "irradiance"),
                               colourTexture(context, bake->lightDirection, {}, "light_direction")});
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

std::vector<std::string> Light::defines() const {
    return textures_ ? std::vector<std::string>{"BAKED_LIGHT"} : std::vector<std::string>{};
}

std::vector<std::pair<std::string, std::size_t>> Light::textures() const {
    if (!textures_) return {};
    return {{textures_->irradiance.label(), textures_->irradiance.bytes()},
            {textures_->direction.label(), textures_->direction.bytes()}};
}

} // namespace eikonal::viewer

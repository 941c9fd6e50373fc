#pragma once
// The baked light as textures of the viewer.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/baked_light.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class Light {
public:
    /// Uploads a bake; nullptr: no light, no texture.
    Light(const gpu::Context& context, const BakedLight* bake);

    void configure(gpu::ViewBlock& view) const;
    void bind() const;
    /// "BAKED_LIGHT" if there is one, "LIGHT_LOBES" if it has lobes.
    std::vector<std::string> defines() const;
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    struct Textures {
        Lattice lattice;
        gpu::Texture3D irradiance, direction;
        std::optional<gpu::Texture2D> lobes;
    };
    std::optional<Textures> textures_;
};

} // namespace eikonal::viewer

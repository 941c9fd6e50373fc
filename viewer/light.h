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
    /// Uploads a bake; nullptr: no light, no texture. Its bands are used if there are `bandCount` of them.
    Light(const gpu::Context& context, const BakedLight* bake, std::size_t bandCount);

    void configure(gpu::ViewBlock& view) const;
    /// True if every band has a grid of its own.
    bool isByBand() const { return textures_ && !textures_->bands.empty(); }
    void bind() const;
    /// The irradiance of a band, in all channels. Without grids by band the one of all is bound.
    void bindBand(std::size_t band) const;
    /// "BAKED_LIGHT" if there is one, "LIGHT_LOBES" if it has lobes.
    std::vector<std::string> defines() const;
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    struct Textures {
        Lattice lattice;
        gpu::Texture3D irradiance, direction;
        std::optional<gpu::Texture2D> lobes;
        std::vector<gpu::Texture3D> bands;
    };
    std::optional<Textures> textures_;
};

} // namespace eikonal::viewer

#pragma once
// The fields of a scene as textures: exactly those that its effects need (shaders/fields/fields.glsl reads them).

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "common/gpu_insets.h"
#include "shaders/shared/domain_block.h"

namespace eikonal {

class GpuFields {
public:
    /// Uploads the grids of every effect that is on; `interpolation`, linear or cubic, is that of the index on the domain's
    /// lattice. Throws badInput for a lattice beyond the device's 3D textures, std::logic_error for an effect whose grid is
    /// missing.
    GpuFields(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
              Interpolation interpolation = Interpolation::kLinear);

    /// The wavelength of what is dispatched from now on; at first the reference's, of which `ior` is the index. Without
    /// dispersion it makes no difference.
    void setWavelength(double micrometres);
    /// The same insets elsewhere (GpuInsets::move).
    void moveInsets(const Fields& fields);
    /// How fine insets are; without any, the domain's voxels.
    InsetBounds insetBounds() const { return insets_ ? insets_->bounds() : InsetBounds{}; }
    /// Binds textures and the domain block to the units of shaders/shared/bindings.h.
    void bind() const;
    /// What kernels that include fields/fields.glsl are compiled with: the effects, and how textures are filtered.
    const std::vector<std::string>& defines() const { return defines_; }
    /// Name and bytes of each texture, for the statistics.
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    struct BoundTexture {
        int unit;
        gpu::Texture3D texture;
    };

    std::optional<double> cauchyOverRefractivity_;
    gpu::DomainBlock block_;
    gpu::Buffer domain_;
    std::vector<std::string> defines_;
    std::vector<BoundTexture> textures_;
    std::optional<GpuInsets> insets_;
};

/// Uploads a vec3 grid as an RGBA texture; alpha is the matching value of `alpha`, or 0 where that is empty. Where all is grey and
/// alpha 0, one channel holds it, which takes a quarter of the memory and of the work of a fetch in software.
gpu::Texture3D colourTexture(const gpu::Context& context, const DenseGrid<glm::vec3>& grid,
                             const DenseGrid<float>& alpha, std::string_view label);

} // namespace eikonal

#pragma once
// Objects with lattices of their own on the device: one texture for the values of all of them, one for their extents, and
// where each lies (shaders/fields/insets.glsl reads them).

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "common/gpu/row_buffer.h"
#include "common/inset_bricks.h"
#include "shaders/shared/inset_blocks.h"

namespace eikonal {

class GpuInsets {
public:
    /// Uploads what the effects that are on need of `fields.insets`. Throws badInput for textures beyond the device.
    GpuInsets(const gpu::Context& context, const Fields& fields, const EffectSet& effects);

    /// The same insets elsewhere: `fields.insets` have the grids that they had, or std::logic_error.
    void move(const Fields& fields);
    void bind() const;
    const InsetBounds& bounds() const { return bounds_; }
    /// Name and bytes of each texture.
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    gpu::InsetsBlock block_{};
    std::vector<gpu::InsetRows> rows_;
    gpu::Buffer blockBuffer_;
    gpu::RowBuffer rowBuffer_, bricks_;
    gpu::Texture3D values_, extents_;
    InsetBounds bounds_;
};

} // namespace eikonal

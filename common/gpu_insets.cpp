#include "common/gpu_insets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "common/atlas.h"
#include "common/device_frame.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/depth_range.h"

namespace eikonal {

namespace {

static_assert(sizeof(InsetBrick) == 8 && offsetof(InsetBrick, finestVoxel) == 4);  // a uvec2 of the shading language

/// The effect that a quantity of an inset is uploaded for; none: it is never more than four numbers.
std::optional<Effect> effectOf(int quantity) {
    switch (quantity) {
        case gpu::kInsetCoverage:
        case gpu::kInsetIndex: return Effect::kRefraction;
        case gpu::kInsetDispersion: return Effect::kDispersion;
        case gpu::kInsetAbsorption: return Effect::kAbsorption;
        case gpu::kInsetScattering:
        case gpu::kInsetAnisotropy: return Effect::kScattering;
        case gpu::kInsetEmission: return Effect::kEmission;
        case gpu::kInsetOpaque: return Effect::kOpaque;
        default: return std::nullopt;
    }
}

bool needsExtents(const EffectSet& effects) {
    constexpr std::array kEffects{Effect::kAbsorption, Effect::kScattering, Effect::kEmission, Effect::kReflection,
                                  Effect::kOpaque};
    return std::any_of(kEffects.begin(), kEffects.end(), [&](Effect effect) { return effects.has(effect); });
}

/// Texels that lie x fastest in a box, copied to where the atlas has it.
template <class Texel>
void copyBox(const std::vector<Texel>& box, const glm::ivec3& size, const glm::ivec3& first, const glm::ivec3& atlasSize,
             std::vector<Texel>& atlas) {
    auto row = box.begin();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j, row += size.x) {
            const std::size_t line = std::size_t(first.z + k) * std::size_t(atlasSize.y) + std::size_t(first.y + j);
            std::copy_n(row, size.x, atlas.begin() + std::ptrdiff_t(line * std::size_t(atlasSize.x)) + first.x);
        }
    }
}

std::size_t countOf(const glm::ivec3& size) { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }

/// A quantity of an inset that goes into the atlas of values.
struct Box {
    std::size_t inset;
    int quantity;
};

std::vector<Box> boxesOf(const Fields& fields, const EffectSet& effects) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < fields.insets.size(); ++i) {
        for (int quantity = 0; quantity < gpu::kInsetQuantities; ++quantity) {
            const auto effect = effectOf(quantity);
            const bool varies = !fields.insets[i].grids->quantities[std::size_t(quantity)].varying.empty();
            if (varies && effect && effects.has(*effect)) boxes.push_back({i, quantity});
        }
    }
    return boxes;
}

gpu::Texture3D valueTexture(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                            gpu::InsetsBlock& block, std::vector<gpu::InsetRows>& rows) {
    const std::vector<Box> boxes = boxesOf(fields, effects);
    std::vector<glm::ivec3> sizes;
    for (const Box& box : boxes) sizes.push_back(fields.insets[box.inset].grids->lattice.size);
    const Atlas atlas = packed(sizes, context.limits().maxTexture3dSize);
    gpu::Texture3D texture(context, gpu::TexelFormat::kRgba32f, atlas.size, "inset_values");
    std::vector<glm::vec4> texels(countOf(atlas.size), glm::vec4(0.0f));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto& quantity = fields.insets[boxes[i].inset].grids->quantities[std::size_t(boxes[i].quantity)];
        copyBox(quantity.varying, sizes[i], atlas.first[i], atlas.size, texels);
        rows[boxes[i].inset].first[boxes[i].quantity] = glm::ivec4(atlas.first[i], 1);
    }
    texture.upload(texels.data());
    block.insetValueScale = 1.0f / glm::vec3(atlas.size);
    return texture;
}

using ExtentTexel = std::array<std::uint16_t, 2>;

/// Area coverage and the band of the boundary. Opaque insets have their depth, as a share of its range, in place of the first.
std::vector<ExtentTexel> extentTexels(const InsetGrids& grids) {
    std::vector<ExtentTexel> texels(grids.depth.values.size());
    const float least = grids.displaces ? 0.0f : gpu::kLeastDepth, most = grids.displaces ? 1.0f : gpu::kMostDepth;
    for (std::size_t v = 0; v < texels.size(); ++v) {
        const float extent = std::clamp((grids.depth.values[v] - least) / (most - least), 0.0f, 1.0f);
        const bool inBand = !grids.boundary.empty() && grids.boundary.values[v] != 0;
        texels[v] = {std::uint16_t(std::lround(65535.0f * extent)), std::uint16_t(inBand ? 65535 : 0)};
    }
    return texels;
}

gpu::Texture3D extentTexture(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                             gpu::InsetsBlock& block, std::vector<gpu::InsetRows>& rows) {
    std::vector<glm::ivec3> sizes;
    if (needsExtents(effects)) {
        for (const Inset& inset : fields.insets) sizes.push_back(inset.grids->lattice.size);
    }
    const Atlas atlas = packed(sizes, context.limits().maxTexture3dSize);
    gpu::Texture3D texture(context, gpu::TexelFormat::kRg16, atlas.size, "inset_extents");
    std::vector<ExtentTexel> texels(countOf(atlas.size), ExtentTexel{});
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        copyBox(extentTexels(*fields.insets[i].grids), sizes[i], atlas.first[i], atlas.size, texels);
        rows[i].extentFirst = atlas.first[i];
    }
    texture.upload(texels.data());
    block.insetExtentScale = 1.0f / glm::vec3(atlas.size);
    return texture;
}

std::vector<gpu::InsetRows> rowsOf(const Fields& fields) {
    std::vector<gpu::InsetRows> rows(fields.insets.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const InsetGrids& grids = *fields.insets[i].grids;
        rows[i].size = grids.lattice.size;
        rows[i].displaces = grids.displaces ? 1 : 0;
        for (std::size_t q = 0; q < grids.quantities.size(); ++q) {
            rows[i].everywhere[q] = grids.quantities[q].everywhere;
        }
    }
    return rows;
}

/// Rows of the map from the device's coordinates to an inset's voxels, counted from its lower corner.
void place(const Inset& inset, const Lattice& domain, gpu::InsetRows& rows) {
    const Lattice& lattice = inset.grids->lattice;
    const glm::dmat4 localFromWorld = glm::inverse(inset.worldFromLocal);
    const glm::dvec3 middle = glm::dvec3(localFromWorld * glm::dvec4(middleOf(domain), 1.0));
    for (int row = 0; row < 3; ++row) {
        const glm::dvec3 along(localFromWorld[0][row], localFromWorld[1][row], localFromWorld[2][row]);
        rows.placeFromDevice[row] = glm::vec4(glm::dvec4(along, middle[row] - lattice.min[row]) / lattice.voxel);
    }
}

/// Of whole rows.
std::size_t brickBytes(const Fields& fields) {
    const std::size_t bricks = countOf((fields.lattice.size + kBrickVoxels - 1) / kBrickVoxels);
    return (bricks + gpu::kInsetBricksPerRow - 1) / gpu::kInsetBricksPerRow * gpu::kInsetBricksPerRow * sizeof(InsetBrick);
}

} // namespace

GpuInsets::GpuInsets(const gpu::Context& context, const Fields& fields, const EffectSet& effects)
    : rows_(rowsOf(fields)), blockBuffer_(context, sizeof block_, "insets"),
      rowBuffer_(context, rows_.size() * sizeof(gpu::InsetRows), "inset rows"),
      bricks_(context, brickBytes(fields), "inset bricks"), values_(valueTexture(context, fields, effects, block_, rows_)),
      extents_(extentTexture(context, fields, effects, block_, rows_)) {
    blockBuffer_.upload(block_);
    move(fields);
}

void GpuInsets::move(const Fields& fields) {
    if (fields.insets.size() != rows_.size()) throw std::logic_error("other insets than those that move");
    for (std::size_t i = 0; i < rows_.size(); ++i) place(fields.insets[i], fields.lattice, rows_[i]);
    rowBuffer_.upload(std::span<const gpu::InsetRows>(rows_));
    const DenseGrid<InsetBrick> bricks = insetBricksOf(fields);
    bounds_ = boundsOf(bricks);
    bricks_.upload(std::span<const InsetBrick>(bricks.values));
}

void GpuInsets::bind() const {
    blockBuffer_.bindUniform(gpu::kUniformInsets);
    rowBuffer_.bindTexels(gpu::kUnitInsetRows);
    bricks_.bindTexels(gpu::kUnitInsetBricks);
    values_.bind(gpu::kUnitInsetValues);
    extents_.bind(gpu::kUnitInsetExtents);
}

std::vector<std::pair<std::string, std::size_t>> GpuInsets::textures() const {
    return {{values_.label(), values_.bytes()}, {extents_.label(), extents_.bytes()}};
}

} // namespace eikonal

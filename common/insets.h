#pragma once
// Objects with lattices of their own: composed once, each by itself, and laid over the domain's grids when viewing rays look
// (docs/physics.md, section 2; shaders/fields/insets.glsl).

#include <array>
#include <vector>

#include "common/field_pyramid.h"
#include "common/fields.h"
#include "shaders/shared/inset_blocks.h"

namespace eikonal {

/// A quantity of shared/inset_blocks.h over an inset's lattice.
struct InsetQuantity {
    glm::vec4 everywhere{0.0f};     ///< what the object holds, where that is the same in all of it
    std::vector<glm::vec4> varying; ///< else, voxel by voxel, times its coverage; empty otherwise
    bool present = false;           ///< false: the object has none
};

/// An object over nothing, in its own coordinates and unit.
struct InsetGrids {
    Lattice lattice;
    std::array<InsetQuantity, gpu::kInsetQuantities> quantities;
    DenseGrid<float> depth;             ///< in it, of which the share of each voxel's cube follows (common/depth.h)
    DenseGrid<unsigned char> boundary;  ///< 255 in the band of its boundary; empty: it has none that changes the index
    FieldPyramid pyramid;               ///< of its index times coverage, and its matter; lengths in its own unit
    bool displaces = true;              ///< false: it is opaque, and leaves the matter that it lies over
    float iorMin = 1.0f, iorMax = 1.0f; ///< of its matter; 1 where it leaves the index

    bool has(int quantity) const { return quantities[std::size_t(quantity)].present; }
    /// Of all that is kept of it in memory.
    std::size_t bytes() const;
};

/// The objects of a scene that have a resolution, in its order. Throws badInput as composeImageFields.
std::vector<Inset> composeInsets(const Scene& scene);

/// The same objects where they are now: `insets` are those of a scene that differs from this one in their transforms alone.
std::vector<Inset> movedInsets(const Scene& scene, std::vector<Inset> insets);

/// Objects with a resolution are laid over the others: throws badInput for one without that comes later and may overlap one.
void requireInsetsComeLast(const Scene& scene);

/// The edge of an inset's voxels [scene units].
double voxelOf(const Inset& inset);

/// Whether a part of an inset's lattice lies outside the domain, where it is not seen.
bool reachesBeyond(const Inset& inset, const Lattice& domain);

} // namespace eikonal

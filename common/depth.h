#pragma once
// Grids of depths in matter (shaders/physics/depth.glsl): where it begins, to a fraction of a voxel.

#include <cstddef>

#include "common/lattice.h"
#include "shaders/shared/depth_range.h"

namespace eikonal {

/// From a signed distance [voxels], as far as gpu::kLeastDepth and gpu::kMostDepth.
double depthFromDistance(double distanceVoxels);

/// What depth is known of where only shares of voxels' cubes are: as they are about the surface, all or nothing beyond what
/// interpolation and normals see from there.
DenseGrid<float> depthFromShares(const DenseGrid<float>& shares);

/// The shares of voxels' cubes that matter takes.
DenseGrid<float> sharesOf(DenseGrid<float> depth);

/// The share of a voxel's cube that light can be in. No grid: all of it.
double freeShareAt(const DenseGrid<float>& opaqueDepth, std::size_t offset);

/// What either of two bodies takes, what both do, and what the first does without the second.
DenseGrid<float> joined(const DenseGrid<float>& a, const DenseGrid<float>& b);
DenseGrid<float> overlap(const DenseGrid<float>& a, const DenseGrid<float>& b);
DenseGrid<float> without(const DenseGrid<float>& a, const DenseGrid<float>& b);

} // namespace eikonal

#pragma once
// Where the fields hold detail that rays which lie voxels apart could pass without seeing it.

#include "common/fields.h"
#include "common/gpu/objects.h"

namespace eikonal::bake {

/// From each brick of kBrickVoxels to the nearest that holds detail, in bricks (Chebyshev); 0 in one that does, 255 at most.
/// Detail is what changes from one voxel to the next by so much that a ray between two others, a few voxels off, may not go
/// where they say: the gradient of the index, optical depth, opaque matter. A lens whose index is smooth has none.
DenseGrid<unsigned char> distanceToDetail(const Fields& fields);

/// The same as a texture of normalised bytes.
gpu::Texture3D detailTexture(const gpu::Context& context, const DenseGrid<unsigned char>& distance);

/// Whether there is any.
bool isAnywhere(const DenseGrid<unsigned char>& distanceToDetail);

} // namespace eikonal::bake

#pragma once
// True Gaussian blur, separable, on dense grids.

#include "common/lattice.h"

namespace eikonal {

/// Standard deviation in voxels, cut off at 4 of them; beyond the faces the outermost values continue.
DenseGrid<glm::vec3> gaussianBlur(const DenseGrid<glm::vec3>& grid, double sigmaVoxels);

} // namespace eikonal

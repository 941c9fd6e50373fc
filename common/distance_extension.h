#pragma once
// Narrow-band level sets continued outwards and inwards.

#include "common/lattice.h"

namespace eikonal {

/// Replaces values of |d| >= known by the distance that |grad d| = 1 continues from nearer voxels, keeping their sign.
/// First-order fast sweeping (H. Zhao, "A fast sweeping method for eikonal equations", 2005). All in voxels.
void extendDistance(DenseGrid<float>& distanceVoxels, double known);

} // namespace eikonal

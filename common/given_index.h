#pragma once
// What a bare `ior` grid does not say: where its boundaries are, and which voxels hold matter.

#include "common/lattice.h"

namespace eikonal {

struct GivenIndex {
    DenseGrid<unsigned char> boundary;  ///< 255 in the band of a boundary, tails included
    DenseGrid<float> matter;            ///< 0 where the index is the grid's background, 1 where it is not, by area between
};

/// A boundary is a monotone piece of n along its gradient that is no wider than smoothing can have made it:
/// W = |Δn| / max|∇n| <= 1.5 sqrt(2π) max(b, 1.5), all in voxels (an erfc profile of width b has W = sqrt(2π) b).
/// A piece ends where |∇n| falls below 2 % of its largest, or turns round.
GivenIndex analyseGivenIndex(const DenseGrid<float>& ior, double smoothVoxels, double background);

} // namespace eikonal

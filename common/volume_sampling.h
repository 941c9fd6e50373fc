#pragma once
// Grids of other lattices brought to the domain's.

#include "common/lattice.h"
#include "common/vdb_io.h"

namespace eikonal {

/// A file's grid as it lies in the world, after the object's transform.
struct PlacedGrid {
    const VdbGrid* grid = nullptr;
    glm::dmat4 gridFromDomainIndex{1.0};  ///< from the domain's indices to those of `grid->values`

    /// Snaps to the exact map where the two lattices coincide, so that values are copied and not interpolated.
    PlacedGrid(const VdbGrid& source, const glm::dmat4& worldFromLocal, const Lattice& lattice);
};

/// Trilinear values at the centres of the domain's voxels; scalars in all three bands. Up to half a voxel outside the
/// outermost centres the edge's values hold; farther out the grid's background.
DenseGrid<glm::vec3> resample(const PlacedGrid& placed, const Lattice& lattice);

/// Of what is the same in all three bands.
DenseGrid<float> firstComponent(const DenseGrid<glm::vec3>& grid);

/// 1 where a voxel's centre lies in the grid's active box, to the outer edges of its voxels; 0 elsewhere.
DenseGrid<float> boxCoverage(const PlacedGrid& placed, const Lattice& lattice);

} // namespace eikonal

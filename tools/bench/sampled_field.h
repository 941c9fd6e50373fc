#pragma once
// Closed forms on voxels.

#include <functional>

#include "common/fields.h"

namespace eikonal::bench {

/// Voxels of the box about the origin.
Lattice cubeLattice(int resolution, double halfEdge);

template <class Visit>
void forEachVoxel(const Lattice& lattice, const Visit& visit) {
    for (int k = 0; k < lattice.size.z; ++k) {
        for (int j = 0; j < lattice.size.y; ++j) {
            for (int i = 0; i < lattice.size.x; ++i) {
                visit(glm::ivec3(i, j, k));
            }
        }
    }
}

/// n at the voxels' centres and its gradient; no matter, no interfaces.
Fields sampledField(const Lattice& lattice, const std::function<double(const glm::dvec3&)>& n);

} // namespace eikonal::bench

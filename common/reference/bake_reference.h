#pragma once
// The truth that the light simulator is judged by: very many rays in double precision, short steps, and each step's power
// times length added to the cube that holds its middle. No patches, no splats, no fixed point.
// The steps are those of shaders/physics.

#include "common/lattice.h"
#include "common/reference/reference_field.h"

namespace eikonal::reference {

struct BeamBakeOptions {
    int raysPerVoxelEdge = 32;  ///< the beam is cut into this many strata per voxel edge, a ray in each centre
    double stepVoxels = 0.1;
    double maxPathDiagonals = 12.0;
};

/// Irradiance [power / scene unit²] of a unit beam along +x, cube means, by two threads. The field and the lattice are
/// symmetric about the x axis (four mirrors) and y and z alike: only the rays of one eighth are followed.
/// Defined for SmoothedSphere and GridField.
template <class Field>
DenseGrid<glm::dvec3> bakeSymmetricBeam(const Field& field, const Lattice& lattice, const BeamBakeOptions& options);

} // namespace eikonal::reference

#pragma once
// The truth that the light simulator is judged by: very many rays in double precision, short steps, and each step's power
// times length added to the cube that holds its middle. No patches, no splats, no fixed point.
// The steps are those of shaders/physics.

#include <vector>

#include "common/lattice.h"
#include "common/reference/reference_field.h"

namespace eikonal::reference {

struct BeamBakeOptions {
    int raysPerVoxelEdge = 32;  ///< the beam is cut into this many strata per voxel edge, a ray in each centre
    double stepVoxels = 0.1;
    double maxPathDiagonals = 12.0;
};

/// Irradiance [power / scene unit²] of a unit beam along +x through a lattice as wide as high, cube means, by two threads.
/// Defined for ClosedForm.
template <class Field>
DenseGrid<glm::dvec3> bakeBeam(const Field& field, const Lattice& lattice, const BeamBakeOptions& options);

/// The same where the field and the lattice are symmetric about the x axis (four mirrors) and y and z alike: only the rays of
/// one eighth are followed. Defined for SmoothedSphere and GridField.
template <class Field>
DenseGrid<glm::dvec3> bakeSymmetricBeam(const Field& field, const Lattice& lattice, const BeamBakeOptions& options);

/// What arrives in a voxel: moments of its directions, and what smoke there scatters, over its coefficient.
struct VoxelArrivals {
    double irradiance = 0.0;     ///< [power / scene unit²]
    glm::dvec3 flux{0.0};        ///< [power / scene unit²]
    std::vector<double> phased;  ///< irradiance × phase function, against each direction of view [power / scene unit² sr]

    /// Light along a unit direction.
    void add(const glm::dvec3& direction, double arriving, const std::vector<glm::dvec3>& viewDirections, double g);
    VoxelArrivals& operator+=(const VoxelArrivals& other);
};

/// The same beam, every arrival by its own direction, in some voxels. Defined for GridField.
template <class Field>
std::vector<VoxelArrivals> symmetricBeamArrivals(const Field& field, const Lattice& lattice, const BeamBakeOptions& options,
                                                 const std::vector<glm::ivec3>& voxels,
                                                 const std::vector<glm::dvec3>& viewDirections, double g);

} // namespace eikonal::reference

#pragma once
// The power that each ray of a launch mesh stands for, in the energy ledger: what the sub-cells about it launch.

#include <vector>

#include <glm/glm.hpp>

#include "common/lattice.h"
#include "lightsim/emit.h"
#include "lightsim/tubes/launch_mesh.h"

namespace eikonal::bake {

/// By vertex of the mesh and band. A corner of a sub-cell has a quarter of its power; where the rim of the domain's box, as its light
/// sees it, lies between them, those within share what meets the domain, those outside what does not.
std::vector<glm::dvec4> powerOfRays(const LaunchMesh& mesh, const LaunchGrids& grids, const Lattice& domain);

} // namespace eikonal::bake

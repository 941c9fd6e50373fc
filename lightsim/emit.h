#pragma once
// Emit: the lights of a scene as launch surfaces, from which patches begin.

#include <vector>

#include <glm/glm.hpp>

#include "common/lattice.h"
#include "lightsim/light_set.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal::bake {

/// The launch grids of all lights, cells numbered through.
struct LaunchGrids {
    std::vector<LaunchFrame> frames;
    std::uint32_t cellCount = 0;
    glm::dvec3 emitted{0.0};  ///< power of all lights (a beam's over the projected area of the domain)
    double strongestPower = 0.0;      ///< bound of the power launched, strongest band
    double strongestCellPower = 0.0;  ///< bound of the power of one cell, strongest band
};

struct Criteria;

/// Launch grids whose cells are at most Criteria::maxSide [scene units] where a beam or a distant light enters the domain, and
/// small angles about a near one. Patches with less than Criteria::splitShare of what their light launches are not split; less
/// by the root of their number where many sources stand for one light.
LaunchGrids launchGrids(const LightSet& lights, const Lattice& lattice, const Criteria& criteria);

} // namespace eikonal::bake

#pragma once
// What the light simulator leaves for the viewer (docs/scene.md, grids of a bake).

#include "common/lattice.h"

namespace eikonal {

struct BakedLight {
    Lattice lattice;
    DenseGrid<glm::vec3> irradiance;      ///< scalar irradiance per band, mean over each voxel [power / scene unit²]
    DenseGrid<glm::vec3> lightDirection;  ///< flux vector over scalar irradiance, summed over bands; length <= 1
};

} // namespace eikonal

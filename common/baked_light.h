#pragma once
// What the light simulator leaves for the viewer (docs/scene.md, grids of a bake).

#include "common/lattice.h"

namespace eikonal {

/// In an eikonal: no light has come here.
inline constexpr float kUnreached = -1.0f;

struct BakedLight {
    Lattice lattice;
    DenseGrid<glm::vec3> irradiance;      ///< scalar irradiance per band, mean over each voxel [power / scene unit²]
    DenseGrid<glm::vec3> lightDirection;  ///< flux vector over scalar irradiance, summed over bands; length <= 1
    DenseGrid<float> eikonal{};  ///< least optical path from a light to each voxel's middle [scene units], or kUnreached;
                                 ///< empty where not asked for
};

} // namespace eikonal

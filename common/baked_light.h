#pragma once
// What the light simulator leaves for the viewer (docs/scene.md, grids of a bake).

#include <vector>

#include "common/lattice.h"

namespace eikonal {

/// Scalar irradiance of a spectral band, relative to white: an equal value in all bands is white [power / scene unit²].
struct BandIrradiance {
    double wavelengthNm = 0.0;
    DenseGrid<float> irradiance;
};

struct BakedLight {
    Lattice lattice;
    /// Scalar irradiance, mean over each voxel [power / scene unit²]: of red, green and blue, or the linear Rec.709 that the
    /// spectral bands add up to.
    DenseGrid<glm::vec3> irradiance;
    DenseGrid<glm::vec3> lightDirection;  ///< flux vector over scalar irradiance, summed over bands; length <= 1
    std::vector<BandIrradiance> bands;    ///< where something disperses and there are more than three; else empty
};

} // namespace eikonal

#pragma once
// What the light simulator leaves for the viewer (docs/scene.md, grids of a bake).

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "common/lattice.h"

namespace eikonal {

/// Scalar irradiance of a spectral band, relative to white: an equal value in all bands is white [power / scene unit²].
struct BandIrradiance {
    double wavelengthNm = 0.0;
    DenseGrid<float> irradiance;
};

/// Light of a voxel that comes from about one direction.
struct LightLobe {
    glm::vec3 irradiance{0.0f};  ///< scalar irradiance per band [power / scene unit²]; 0: there is no such lobe
    glm::vec3 direction{0.0f};   ///< flux vector over scalar irradiance, summed over bands; length <= 1: how narrow it is

    bool operator==(const LightLobe&) const = default;
};

constexpr std::size_t kMostLobes = 3;
/// Lobes of a voxel, the strongest first.
using VoxelLobes = std::array<LightLobe, kMostLobes>;

/// The lobes of those voxels whose light comes from several directions; elsewhere the whole light is one lobe. Irradiances
/// and fluxes of a voxel's lobes add up to the voxel's.
struct LobeTable {
    std::vector<std::uint32_t> voxels;  ///< offsets into the grids, ascending
    std::vector<VoxelLobes> rows;       ///< one a voxel

    bool empty() const { return voxels.empty(); }
    /// Row of a voxel, or nullptr.
    const VoxelLobes* find(std::uint32_t voxel) const {
        const auto found = std::lower_bound(voxels.begin(), voxels.end(), voxel);
        return found != voxels.end() && *found == voxel ? &rows[std::size_t(found - voxels.begin())] : nullptr;
    }
};

/// In an eikonal: no light has come here.
inline constexpr float kUnreached = -1.0f;

struct BakedLight {
    Lattice lattice;
    /// Scalar irradiance, mean over each voxel [power / scene unit²]: of red, green and blue, or the linear Rec.709 that the
    /// spectral bands add up to.
    DenseGrid<glm::vec3> irradiance;
    DenseGrid<glm::vec3> lightDirection;  ///< flux vector over scalar irradiance, summed over bands; length <= 1
    LobeTable lobes = {};                 ///< empty: none were asked for, or none are needed
    DenseGrid<float> eikonal{};  ///< least optical path from a light to each voxel's middle [scene units], or kUnreached;
                                 ///< empty where not asked for
    std::vector<BandIrradiance> bands{};  ///< where something disperses and there are more than three; else empty
};

/// Sum over bands.
inline double overBands(const glm::vec3& irradiance) {
    return double(irradiance.x) + double(irradiance.y) + double(irradiance.z);
}

} // namespace eikonal

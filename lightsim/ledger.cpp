#include "lightsim/ledger.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "common/depth.h"
#include "lightsim/light_sums.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal {

glm::dvec3 EnergyLedger::balance() const {
    const glm::dvec3 accounted = absorbed + scattered + exited + reflected + culled;
    glm::dvec3 rest(0.0);
    for (int band = 0; band < 3; ++band) {
        rest[band] = entered[band] > 0.0 ? 1.0 - accounted[band] / entered[band] : 0.0;
    }
    return rest;
}

namespace bake {

void readLedger(const gpu::Buffer& rows, double unit, EnergyLedger& ledger) {
    const auto words = rows.download<std::uint32_t>(LEDGER_ROWS * 3 * 2);
    const auto row = [&](std::size_t i) {
        glm::dvec3 power;
        for (std::size_t band = 0; band < 3; ++band) {
            const std::size_t word = 2 * (3 * i + band);
            power[int(band)] = fixedPointValue(words[word], words[word + 1]) * unit;
        }
        return power;
    };
    ledger.entered = row(LEDGER_ENTERED);
    ledger.absorbedOpaque = row(LEDGER_OPAQUE);
    ledger.absorbedByTint = row(LEDGER_TINTED);
    ledger.absorbed = row(LEDGER_ABSORBED) + ledger.absorbedOpaque + ledger.absorbedByTint;
    ledger.scattered = row(LEDGER_SCATTERED);
    ledger.exited = row(LEDGER_EXITED);
    ledger.followed = row(LEDGER_FOLLOWED);
    ledger.reflected = row(LEDGER_REFLECTED) - ledger.followed;
    ledger.culled = row(LEDGER_CULLED);
}

namespace {

/// Values of a grid about a voxel, clamped at the faces.
glm::dvec3 valueNear(const DenseGrid<glm::vec3>& grid, const glm::ivec3& voxel, const glm::ivec3& offset) {
    return glm::dvec3(grid.at(glm::clamp(voxel + offset, glm::ivec3(0), grid.size - 1)));
}

/// Mean over a voxel's length of what is linear between its middle and its neighbours'.
glm::dvec3 meanAlong(const glm::dvec3& before, const glm::dvec3& here, const glm::dvec3& after) {
    return 0.125 * before + 0.75 * here + 0.125 * after;
}

/// Mean over a voxel's length of its product with the place in it, from -1/2 to 1/2 voxel.
glm::dvec3 momentAlong(const glm::dvec3& before, const glm::dvec3& after) { return (after - before) / 24.0; }

/// Of the trilinear interpolant over the cube of a voxel: its mean, and the means of its product with the place along each axis,
/// counted in voxels from the middle.
struct CubeMoments {
    glm::dvec3 mean;
    std::array<glm::dvec3, 3> first;
};

/// Of the voxels of a row along x.
std::vector<CubeMoments> cubeMoments(const DenseGrid<glm::vec3>& grid, int j, int k) {
    const int last = grid.size.x - 1;
    const auto rowAt = [&](int dj, int dk) {
        return &grid.at({0, std::clamp(j + dj, 0, grid.size.y - 1), std::clamp(k + dk, 0, grid.size.z - 1)});
    };
    const glm::vec3* rows[3][3];
    for (int at = 0; at < 9; ++at) {
        rows[at / 3][at % 3] = rowAt(at % 3 - 1, at / 3 - 1);
    }
    std::vector<CubeMoments> across(grid.size.x), moments(grid.size.x);
    for (int i = 0; i <= last; ++i) {
        std::array<glm::dvec3, 3> means, firsts;
        for (int layer = 0; layer < 3; ++layer) {
            const glm::dvec3 before(rows[layer][0][i]), here(rows[layer][1][i]), after(rows[layer][2][i]);
            means[layer] = meanAlong(before, here, after);
            firsts[layer] = momentAlong(before, after);
        }
        across[i] = {meanAlong(means[0], means[1], means[2]),
                     {glm::dvec3(0.0), meanAlong(firsts[0], firsts[1], firsts[2]), momentAlong(means[0], means[2])}};
    }
    for (int i = 0; i <= last; ++i) {
        const CubeMoments &before = across[std::max(i - 1, 0)], &here = across[i], &after = across[std::min(i + 1, last)];
        moments[i] = {meanAlong(before.mean, here.mean, after.mean),
                      {momentAlong(before.mean, after.mean), meanAlong(before.first[1], here.first[1], after.first[1]),
                       meanAlong(before.first[2], here.first[2], after.first[2])}};
    }
    return moments;
}

/// Changes of the irradiance per voxel along each axis: half of what the neighbours differ by, but as little as keeps what is
/// linear in a voxel's cube from falling below 0 at a corner. Beside a narrow beam the dark would not be dark.
std::array<glm::dvec3, 3> slopesOf(const DenseGrid<glm::vec3>& irradiance, const glm::ivec3& voxel) {
    std::array<glm::dvec3, 3> slopes;
    glm::dvec3 drop(0.0);  // from the middle to the lowest corner
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 next(0);
        next[axis] = 1;
        slopes[axis] = 0.5 * (valueNear(irradiance, voxel, next) - valueNear(irradiance, voxel, -next));
        drop += 0.5 * glm::abs(slopes[axis]);
    }
    constexpr double kTiny = 1e-300;
    const glm::dvec3 kept = glm::min(glm::dvec3(irradiance.at(voxel)) / glm::max(drop, glm::dvec3(kTiny)), glm::dvec3(1.0));
    for (glm::dvec3& slope : slopes) {
        slope *= kept;
    }
    return slopes;
}

/// Mean over the cube of a voxel of sigma times the irradiance.
glm::dvec3 meanProduct(const CubeMoments& sigma, const DenseGrid<glm::vec3>& irradiance, const glm::ivec3& voxel) {
    if (sigma.mean == glm::dvec3(0.0)) {
        return glm::dvec3(0.0);
    }
    const auto slopes = slopesOf(irradiance, voxel);
    return sigma.mean * glm::dvec3(irradiance.at(voxel)) + sigma.first[0] * slopes[0] + sigma.first[1] * slopes[1] +
           sigma.first[2] * slopes[2];
}

glm::dvec3 integral(const DenseGrid<glm::vec3>& sigma, const Fields& fields, VoxelMean mean, const BakedLight& light) {
    const auto ofLayers = [&](const tbb::blocked_range<int>& layers, glm::dvec3 sum) {
        for (int k = layers.begin(); k < layers.end(); ++k) {
            for (int j = 0; j < sigma.size.y; ++j) {
                const auto moments = mean == VoxelMean::kCube ? cubeMoments(sigma, j, k) : std::vector<CubeMoments>();
                for (int i = 0; i < sigma.size.x; ++i) {
                    const glm::ivec3 voxel(i, j, k);
                    const double freeShare = freeShareAt(fields.opaque, sigma.offset(i, j, k));
                    sum += freeShare * (mean == VoxelMean::kCube
                                            ? meanProduct(moments[i], light.irradiance, voxel)
                                            : glm::dvec3(sigma.at(voxel)) * glm::dvec3(light.irradiance.at(voxel)));
                }
            }
        }
        return sum;
    };
    const glm::dvec3 sum = tbb::parallel_deterministic_reduce(tbb::blocked_range<int>(0, sigma.size.z), glm::dvec3(0.0),
                                                              ofLayers, std::plus<>());
    return sum * (light.lattice.voxel * light.lattice.voxel * light.lattice.voxel);
}

} // namespace

void integrateDeposits(const Fields& fields, VoxelMean mean, const BakedLight& light, EnergyLedger& ledger) {
    ledger.depositedAbsorbed = integral(fields.sigmaA, fields, mean, light);
    ledger.depositedScattered = integral(fields.sigmaS, fields, mean, light);
}

} // namespace bake
} // namespace eikonal

#include "lightsim/ledger.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

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

/// Means of the trilinear interpolant over the cubes of a row of voxels along x.
std::vector<glm::dvec3> cubeMeans(const DenseGrid<glm::vec3>& grid, int j, int k) {
    const int last = grid.size.x - 1;
    const auto rowAt = [&](int dj, int dk) {
        return &grid.at({0, std::clamp(j + dj, 0, grid.size.y - 1), std::clamp(k + dk, 0, grid.size.z - 1)});
    };
    std::vector<glm::dvec3> across(grid.size.x), means(grid.size.x);
    const glm::vec3* rows[3][3];
    for (int at = 0; at < 9; ++at) {
        rows[at / 3][at % 3] = rowAt(at % 3 - 1, at / 3 - 1);
    }
    const auto meanOfLayer = [&](const glm::vec3* const (&layer)[3], int i) {
        return meanAlong(glm::dvec3(layer[0][i]), glm::dvec3(layer[1][i]), glm::dvec3(layer[2][i]));
    };
    for (int i = 0; i <= last; ++i) {
        across[i] = meanAlong(meanOfLayer(rows[0], i), meanOfLayer(rows[1], i), meanOfLayer(rows[2], i));
    }
    for (int i = 0; i <= last; ++i) {
        means[i] = meanAlong(across[std::max(i - 1, 0)], across[i], across[std::min(i + 1, last)]);
    }
    return means;
}

/// Mean over the cube of a voxel of the product with what has the mean `sigmaMean` there.
glm::dvec3 meanProduct(const glm::dvec3& sigmaMean, const DenseGrid<glm::vec3>& sigma, const DenseGrid<glm::vec3>& irradiance,
                       const glm::ivec3& voxel) {
    if (sigmaMean == glm::dvec3(0.0)) {
        return glm::dvec3(0.0);
    }
    glm::dvec3 product = sigmaMean * glm::dvec3(irradiance.at(voxel));
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 next(0);
        next[axis] = 1;
        const glm::dvec3 slopes = (valueNear(sigma, voxel, next) - valueNear(sigma, voxel, -next)) *
                                  (valueNear(irradiance, voxel, next) - valueNear(irradiance, voxel, -next));
        product += slopes / (4.0 * 12.0);
    }
    return product;
}

glm::dvec3 integral(const DenseGrid<glm::vec3>& sigma, const Fields& fields, VoxelMean mean, const BakedLight& light) {
    const auto ofLayers = [&](const tbb::blocked_range<int>& layers, glm::dvec3 sum) {
        for (int k = layers.begin(); k < layers.end(); ++k) {
            for (int j = 0; j < sigma.size.y; ++j) {
                const auto means = mean == VoxelMean::kCube ? cubeMeans(sigma, j, k) : std::vector<glm::dvec3>();
                for (int i = 0; i < sigma.size.x; ++i) {
                    const glm::ivec3 voxel(i, j, k);
                    const double freeShare = fields.opaque.empty() ? 1.0 : 1.0 - fields.opaque.at(voxel);
                    sum += freeShare * (mean == VoxelMean::kCube
                                            ? meanProduct(means[i], sigma, light.irradiance, voxel)
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

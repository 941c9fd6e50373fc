#include "lightsim/ledger.h"

#include <functional>

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
template <class Value>
glm::dvec3 valueNear(const DenseGrid<Value>& grid, const glm::ivec3& voxel, const glm::ivec3& offset) {
    return glm::dvec3(grid.at(glm::clamp(voxel + offset, glm::ivec3(0), grid.size - 1)));
}

/// Mean of the trilinear interpolant over the cube of a voxel.
glm::dvec3 cubeMean(const DenseGrid<glm::vec3>& grid, const glm::ivec3& voxel) {
    constexpr double kWeights[3] = {0.125, 0.75, 0.125};
    glm::dvec3 mean(0.0);
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 at(i % 3, i / 3 % 3, i / 9);
        mean += kWeights[at.x] * kWeights[at.y] * kWeights[at.z] * valueNear(grid, voxel, at - 1);
    }
    return mean;
}

/// Mean of the product over the cube of a voxel.
glm::dvec3 meanProduct(const DenseGrid<glm::vec3>& sigma, const DenseGrid<glm::vec3>& irradiance, const glm::ivec3& voxel) {
    glm::dvec3 product = cubeMean(sigma, voxel) * glm::dvec3(irradiance.at(voxel));
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
                for (int i = 0; i < sigma.size.x; ++i) {
                    const glm::ivec3 voxel(i, j, k);
                    const double freeShare = fields.opaque.empty() ? 1.0 : 1.0 - fields.opaque.at(voxel);
                    sum += freeShare * (mean == VoxelMean::kCube
                                            ? meanProduct(sigma, light.irradiance, voxel)
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

#pragma once
// The energy ledger of a bake, from the kernels' books and, independently, from the written grid.

#include "common/baked_light.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "lightsim/bake.h"

namespace eikonal::bake {

/// Reads the rows of the kernels' ledger (shaders/lightsim/ledger.glsl); `unit` is the power of one of its units.
void readLedger(const gpu::Buffer& rows, double unit, EnergyLedger& ledger);

/// What the values of an irradiance grid are means over.
enum class VoxelMean { kCube, kHat };

/// ∫ σ_a E dV and ∫ σ_s E dV of the grids, σ interpolated as rays see it. Where E is a mean over hats that is the plain sum
/// over voxels; where it is a mean over cubes, E is taken as linear in each, as far as it is not below 0 anywhere in it.
void integrateDeposits(const Fields& fields, VoxelMean mean, const BakedLight& light, EnergyLedger& ledger);

} // namespace eikonal::bake

#pragma once
// The energy ledger of a bake, from the kernels' books and, independently, from the written grid.

#include "common/baked_light.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "lightsim/bake.h"

namespace eikonal::bake {

/// Reads the rows of the kernels' ledger (shaders/lightsim/ledger.glsl); `unit` is the power of one of its units.
void readLedger(const gpu::Buffer& rows, double unit, EnergyLedger& ledger);

/// Σ σ_a E V and Σ σ_s E V of the grids, V the free volume of a voxel.
void integrateDeposits(const Fields& fields, const BakedLight& light, EnergyLedger& ledger);

} // namespace eikonal::bake

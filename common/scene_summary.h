#pragma once
// What `eikonal info SCENE` tells: effects with their reasons, memory, and what an image and a bake will cost.

#include <nlohmann/json_fwd.hpp>

#include "common/effects.h"
#include "common/fields.h"
#include "common/scene.h"

namespace eikonal {

/// {"source", "hash", "lattice": {"min", "max", "voxel", "size", "voxels"},
///  "effects": [{"name", "on", "why", "grids", "bytes"}], "memory_bytes", "objects", "lights",
///  "cost": {"image_rays", "image_steps", "bake_patch_steps"}}.
/// Costs are estimates at the default step of one voxel: rays cross the domain along its longest side; patches are
/// one voxel wide. Bytes are those of the grids in memory.
nlohmann::json sceneSummary(const Scene& scene, const Fields& fields);

} // namespace eikonal

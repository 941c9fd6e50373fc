#pragma once
// What `eikonal info SCENE` tells: effects with their reasons, memory, and what an image and a bake will cost.

#include <nlohmann/json_fwd.hpp>

#include "common/scene.h"
#include "common/stage_fields.h"

namespace eikonal {

/// [{"name", "on", "why", "grids", "bytes"}], of all effects; bytes as below.
nlohmann::json effectRows(const EffectSet& effects, const Fields& fields);

/// {"source", "hash", "lattice": {"min", "max", "voxel", "size", "voxels"},
///  "insets": [{"name", "size", "voxel", "voxels", "bytes", "cut"}], "effects": effectRows,
///  "memory_bytes", "objects", "lights",
///  "cost": {"image_rays", "image_steps", "bake_patch_steps"}}.
/// Costs are estimates at the default step of one voxel: rays cross the domain along its longest side; patches are
/// one voxel wide. Bytes are those of the grids in memory: of effects on the domain's lattice, of insets, objects with a
/// resolution of their own, on theirs. What of these reaches beyond the domain is cut.
nlohmann::json sceneSummary(const Scene& scene, const StageFields& stages);

} // namespace eikonal

#pragma once
// Bakes as VDB files: grids `irradiance` and `light_direction`, the irradiance of spectral bands (`irradiance_450nm`, ...),
// the first two for each light where a bake holds them apart (`irradiance_light0`, ...), lobes where it has them
// (tools/lobe_grids.h), and metadata that says what they were baked from.

#include <filesystem>
#include <optional>

#include "common/baked_light.h"
#include "common/fields.h"
#include "common/scene.h"
#include "lightsim/bake.h"

namespace eikonal {

/// File metadata: creator, version, scene (TOML text, everything resolved), scene_hash, energy (JSON text), seconds,
/// renderer, and the number of the frame in a sequence. Throws failure for an unwritable folder or a full disk.
void writeBakeFile(const std::filesystem::path& path, const Scene& scene, const Fields& fields, const BakeResult& result,
                   std::optional<int> frame = std::nullopt);

enum class OtherScene { kRefuse, kAccept };

/// Reads a bake for a scene. Throws badInput for a file that is no bake and, unless told to accept it, for the bake of
/// another scene, naming the keys that differ.
BakedLight readBakeFile(const std::filesystem::path& path, const Scene& scene, const Fields& fields,
                        OtherScene otherScene);

} // namespace eikonal

#pragma once
// Wavefronts as PLY files, for viewers of meshes and for measurements (docs/wavefront.md).

#include <filesystem>
#include <vector>

#include "lightsim/front.h"

namespace eikonal {

/// Binary little-endian PLY, a quad a patch, in the order given. Throws failure as OutputFile.
void writeFrontPly(const std::filesystem::path& path, const std::vector<FrontPatch>& patches);

} // namespace eikonal

#pragma once
// What VDB files cannot hold.

#include <filesystem>

#include "common/lattice.h"

namespace eikonal {

/// Throws badInput for voxels below 1.4e-5 scene units, so that nothing long is computed in vain.
void requireVdbHolds(const std::filesystem::path& path, const Lattice& lattice);

} // namespace eikonal

#pragma once
// OpenVDB's parser, to be run in the reader process only: damaged files crash it, hang it, or make it eat memory.

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "common/vdb_io.h"

namespace eikonal {

/// Both throw badInput with what is wrong with the file.
VdbFile parseVdb(const std::filesystem::path& path);
nlohmann::json summarizeVdb(const std::filesystem::path& path);

} // namespace eikonal

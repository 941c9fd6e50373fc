#pragma once
// Files that belong to the program and are opened on demand: the image module and the VDB reader.

#include <filesystem>
#include <string>

namespace eikonal {

/// Looks beside the executable, in ../lib/eikonal from there, then where the build put it.
/// Throws failure naming the places if there is none.
std::filesystem::path findCompanion(const std::string& name, const std::filesystem::path& buildFolder);

} // namespace eikonal

#pragma once
// What kind of file a name stands for.

#include <filesystem>
#include <string>

namespace eikonal {

/// In lower case, with its dot: ".vdb".
std::string extensionOf(const std::filesystem::path& file);

bool isVolumeFile(const std::filesystem::path& file);
/// Of those that loadMesh reads.
bool isMeshFile(const std::filesystem::path& file);

} // namespace eikonal

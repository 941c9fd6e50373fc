#include "common/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace eikonal {

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

bool isVolumeFile(const std::filesystem::path& file) { return extensionOf(file) == ".vdb"; }

bool isMeshFile(const std::filesystem::path& file) {
    constexpr std::array<std::string_view, 5> kMeshes{".obj", ".ply", ".stl", ".gltf", ".glb"};
    return std::find(kMeshes.begin(), kMeshes.end(), extensionOf(file)) != kMeshes.end();
}

} // namespace eikonal

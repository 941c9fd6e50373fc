#pragma once
// Kernel sources: embedded in the program, includes expanded here, #defines and constants put in front.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal::gpu {

struct EmbeddedShader {
    std::string_view name;  ///< path below shaders/
    std::string_view text;
};

/// Every file below shaders/, generated at build time.
const std::vector<EmbeddedShader>& embeddedShaders();

/// A kernel ready to compile: `#version 450 core`, one `#define` a row of `defines` ("NAME" or "NAME VALUE"), the
/// text of `name` with every `#include "path below shaders/"` expanded once, where it is first met: the folder may stand in
/// front, and no include may be in a branch for C++. `#include <...>` and `#pragma once` are left out.
/// `folder`: where the files are read in place of those in the program, unless empty.
/// Throws std::logic_error for a name that is not embedded, badInput for one that is not in the folder.
std::string kernelSource(std::string_view name, const std::vector<std::string>& defines,
                         const std::filesystem::path& folder = {});

} // namespace eikonal::gpu

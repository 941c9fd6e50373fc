#pragma once
// How many instructions a kernel has, where a driver tells.

#include <cstddef>
#include <optional>
#include <string_view>

namespace eikonal::gpu {

/// Instructions of the assembly that NVIDIA's driver puts into a program's binary (GL_NV_gpu_program5: a statement a line,
/// from "!!NVcp" to "END"). Nothing for what holds no such listing.
std::optional<std::size_t> listedInstructions(std::string_view programBinary);

} // namespace eikonal::gpu

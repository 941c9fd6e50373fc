#pragma once
// Shaders compiled and linked, for the objects that own programs.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "common/gpu/context.h"

namespace eikonal::gpu {

/// A shader by its kind (GL_COMPUTE_SHADER, ...) and its name below shaders/.
struct ShaderStage {
    GLenum kind;
    std::string_view name;
};

/// A program labelled with its last stage's name; the caller deletes it. Throws with the log where a stage does not compile or
/// link: std::logic_error, because the program is broken, or badInput where the context's shaders are files.
GLuint linkedProgram(const Context& context, const std::vector<ShaderStage>& stages, const std::vector<std::string>& defines);

} // namespace eikonal::gpu

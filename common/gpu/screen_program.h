#pragma once
// Draws one triangle that covers the framebuffer, with a fragment shader: how a window shows what kernels have made.

#include <string_view>

#include <epoxy/gl.h>

#include "common/gpu/context.h"

namespace eikonal::gpu {

class ScreenProgram {
public:
    /// Shaders by their names below shaders/. A compile error is a broken program: std::logic_error with the log.
    ScreenProgram(const Context& context, std::string_view vertexShader, std::string_view fragmentShader);
    ScreenProgram(const ScreenProgram&) = delete;
    ScreenProgram& operator=(const ScreenProgram&) = delete;
    ~ScreenProgram();

    /// Into what is bound for drawing, over its whole viewport.
    void draw() const;

private:
    GLuint program_ = 0;
    GLuint vertices_ = 0;  ///< empty: the vertex shader makes the corners
};

} // namespace eikonal::gpu

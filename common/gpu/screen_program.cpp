#include "common/gpu/screen_program.h"

#include "common/gpu/program.h"

namespace eikonal::gpu {

ScreenProgram::ScreenProgram(const Context& context, std::string_view vertexShader, std::string_view fragmentShader)
    : program_(linkedProgram(context, {{GL_VERTEX_SHADER, vertexShader}, {GL_FRAGMENT_SHADER, fragmentShader}}, {})) {
    glCreateVertexArrays(1, &vertices_);
}

ScreenProgram::~ScreenProgram() {
    glDeleteVertexArrays(1, &vertices_);
    glDeleteProgram(program_);
}

void ScreenProgram::draw() const {
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(program_);
    glBindVertexArray(vertices_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace eikonal::gpu

#include "common/gpu/program.h"

#include <stdexcept>

#include "common/error.h"
#include "common/gpu/shader_source.h"

namespace eikonal::gpu {

namespace {

std::string logOf(GLuint name, PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC getLog) {
    GLint length = 0;
    get(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length), '\0');
    getLog(name, length, nullptr, log.data());
    return log;
}

[[noreturn]] void refuse(const Context& context, const std::string& message) {
    if (!context.shaderFolder().empty()) throw badInput(message);
    throw std::logic_error(message);
}

GLuint compiledShader(const Context& context, const ShaderStage& stage, const std::vector<std::string>& defines) {
    const std::string source = kernelSource(stage.name, defines, context.shaderFolder());
    const GLuint shader = glCreateShader(stage.kind);
    const GLchar* text = source.data();
    const GLint length = GLint(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    const std::string log = logOf(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    refuse(context, "shader " + std::string(stage.name) + " does not compile: " + log);
}

} // namespace

GLuint linkedProgram(const Context& context, const std::vector<ShaderStage>& stages,
                     const std::vector<std::string>& defines) {
    std::vector<GLuint> shaders;
    for (const ShaderStage& stage : stages) shaders.push_back(compiledShader(context, stage, defines));
    const GLuint program = glCreateProgram();
    for (const GLuint shader : shaders) {
        glAttachShader(program, shader);
        glDeleteShader(shader);  // lives on while it is attached
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    const std::string_view label = stages.back().name;
    if (linked != GL_TRUE) {
        const std::string log = logOf(program, glGetProgramiv, glGetProgramInfoLog);
        glDeleteProgram(program);
        refuse(context, "shader " + std::string(label) + " does not link: " + log);
    }
    glObjectLabel(GL_PROGRAM, program, GLsizei(label.size()), label.data());
    return program;
}

} // namespace eikonal::gpu

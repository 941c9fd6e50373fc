#include "common/gpu/objects.h"

#include <stdexcept>
#include <utility>

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

GLuint compiledShader(std::string_view name, const std::string& source) {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const GLchar* text = source.data();
    const GLint length = GLint(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    const std::string log = logOf(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    throw std::logic_error("kernel " + std::string(name) + " does not compile: " + log);
}

} // namespace

Kernel::Kernel(const Context&, std::string_view shaderName, const std::vector<std::string>& defines) {
    const GLuint shader = compiledShader(shaderName, kernelSource(shaderName, defines));
    name_ = glCreateProgram();
    glAttachShader(name_, shader);
    glLinkProgram(name_);
    glDetachShader(name_, shader);
    glDeleteShader(shader);
    GLint linked = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        const std::string log = logOf(name_, glGetProgramiv, glGetProgramInfoLog);
        glDeleteProgram(name_);
        throw std::logic_error("kernel " + std::string(shaderName) + " does not link: " + log);
    }
    glObjectLabel(GL_PROGRAM, name_, GLsizei(shaderName.size()), shaderName.data());
}

Kernel::Kernel(Kernel&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

Kernel& Kernel::operator=(Kernel&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
}

Kernel::~Kernel() {
    if (name_) glDeleteProgram(name_);
}

void Kernel::dispatch(const glm::uvec3& groups) const {
    glUseProgram(name_);
    glDispatchCompute(groups.x, groups.y, groups.z);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void Kernel::dispatchIndirect(const Buffer& arguments, std::size_t offset) const {
    glUseProgram(name_);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.name());
    glDispatchComputeIndirect(GLintptr(offset));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace eikonal::gpu

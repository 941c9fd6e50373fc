#include "common/gpu/objects.h"

#include <string>
#include <utility>

#include "common/gpu/instruction_listing.h"
#include "common/gpu/program.h"

namespace eikonal::gpu {

Kernel::Kernel(const Context& context, std::string_view shaderName, const std::vector<std::string>& defines)
    : name_(linkedProgram(context, {{GL_COMPUTE_SHADER, shaderName}}, defines)) {}

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
    dispatchTogether(arguments, {{*this, offset}});
}

std::optional<std::size_t> Kernel::instructions() const {
    GLint bytes = 0;
    glGetProgramiv(name_, GL_PROGRAM_BINARY_LENGTH, &bytes);
    std::string binary(std::size_t(bytes), '\0');
    GLsizei length = 0;
    GLenum format = 0;
    if (bytes > 0) glGetProgramBinary(name_, bytes, &length, &format, binary.data());
    return listedInstructions(std::string_view(binary).substr(0, std::size_t(length)));
}

void Kernel::dispatchTogether(const Buffer& arguments, std::initializer_list<Indirect> dispatches) {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.name());
    for (const auto& [kernel, offset] : dispatches) {
        glUseProgram(kernel.name_);
        glDispatchComputeIndirect(GLintptr(offset));
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace eikonal::gpu

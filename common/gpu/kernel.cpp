#include "common/gpu/objects.h"

#include <utility>

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

void Kernel::dispatchTogether(const Buffer& arguments, std::initializer_list<Indirect> dispatches) {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.name());
    for (const auto& [kernel, offset] : dispatches) {
        glUseProgram(kernel.name_);
        glDispatchComputeIndirect(GLintptr(offset));
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace eikonal::gpu

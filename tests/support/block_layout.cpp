#include "tests/support/block_layout.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace eikonal::test {

namespace {

GLint property(const gpu::Kernel& kernel, GLenum interface, GLuint index, GLenum name) {
    GLint value = 0;
    glGetProgramResourceiv(kernel.name(), interface, index, 1, &name, 1, nullptr, &value);
    return value;
}

std::string resourceName(const gpu::Kernel& kernel, GLenum interface, GLuint index) {
    std::string name(std::size_t(property(kernel, interface, index, GL_NAME_LENGTH)), '\0');
    glGetProgramResourceName(kernel.name(), interface, index, GLsizei(name.size()), nullptr, name.data());
    name.pop_back();  // the terminating zero
    return name;
}

std::vector<GLint> variablesOf(const gpu::Kernel& kernel, GLenum blocks, GLuint block) {
    std::vector<GLint> indices(std::size_t(property(kernel, blocks, block, GL_NUM_ACTIVE_VARIABLES)));
    const GLenum name = GL_ACTIVE_VARIABLES;
    glGetProgramResourceiv(kernel.name(), blocks, block, 1, &name, GLsizei(indices.size()), nullptr, indices.data());
    return indices;
}

BlockLayout layoutOf(const gpu::Kernel& kernel, GLenum blocks, GLenum variables, const std::string& name) {
    const GLuint block = glGetProgramResourceIndex(kernel.name(), blocks, name.c_str());
    if (block == GL_INVALID_INDEX) throw std::logic_error("the kernel has no block " + name);
    BlockLayout layout;
    layout.bytes = std::size_t(property(kernel, blocks, block, GL_BUFFER_DATA_SIZE));
    for (const GLint index : variablesOf(kernel, blocks, block)) {
        layout.members[resourceName(kernel, variables, GLuint(index))] =
            std::size_t(property(kernel, variables, GLuint(index), GL_OFFSET));
        if (variables == GL_BUFFER_VARIABLE) {
            const GLint stride = property(kernel, variables, GLuint(index), GL_TOP_LEVEL_ARRAY_STRIDE);
            layout.stride = std::max(layout.stride, std::size_t(stride));
        }
    }
    return layout;
}

} // namespace

BlockLayout uniformBlockLayout(const gpu::Kernel& kernel, const std::string& block) {
    return layoutOf(kernel, GL_UNIFORM_BLOCK, GL_UNIFORM, block);
}

BlockLayout storageBlockLayout(const gpu::Kernel& kernel, const std::string& block) {
    return layoutOf(kernel, GL_SHADER_STORAGE_BLOCK, GL_BUFFER_VARIABLE, block);
}

Members prefixed(std::string_view prefix, const Members& members, std::size_t offset) {
    Members result;
    for (const auto& [name, at] : members) result[std::string(prefix) + name] = offset + at;
    return result;
}

} // namespace eikonal::test

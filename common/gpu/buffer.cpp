#include "common/gpu/objects.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "common/gpu/transfer.h"

namespace eikonal::gpu {

namespace {

// OpenGL has no buffer of size 0; one word stands for it.
constexpr std::size_t kSmallestBytes = 16;

GLuint storageOf(std::size_t bytes, std::string_view label) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, GLsizeiptr(std::max(bytes, kSmallestBytes)), nullptr, 0);
    glObjectLabel(GL_BUFFER, name, GLsizei(label.size()), label.data());
    return name;
}

} // namespace

Buffer::Buffer(const Context& context, std::size_t bytes, std::string_view label)
    : transfer_(&context.transfer()), label_(label), name_(storageOf(bytes, label)), bytes_(bytes) {}

Buffer::Buffer(Buffer&& other) noexcept
    : transfer_(other.transfer_), label_(std::move(other.label_)), name_(std::exchange(other.name_, 0)),
      bytes_(std::exchange(other.bytes_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(transfer_, other.transfer_);
    std::swap(label_, other.label_);
    std::swap(name_, other.name_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

Buffer::~Buffer() {
    if (name_) glDeleteBuffers(1, &name_);
}

void Buffer::uploadBytes(std::size_t offset, const void* data, std::size_t bytes) {
    assert(offset + bytes <= bytes_);
    transfer_->upload(name_, offset, data, bytes);
}

void Buffer::downloadBytes(std::size_t offset, void* data, std::size_t bytes) const {
    assert(offset + bytes <= bytes_);
    transfer_->download(name_, offset, data, bytes);
}

void Buffer::grow(std::size_t bytes) {
    if (bytes <= bytes_) return;
    const GLuint larger = storageOf(bytes, label_);
    if (bytes_ > 0) glCopyNamedBufferSubData(name_, larger, 0, 0, GLsizeiptr(bytes_));
    glDeleteBuffers(1, &name_);
    name_ = larger;
    bytes_ = bytes;
}

void Buffer::fill(std::uint32_t value) {
    glClearNamedBufferData(name_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

void Buffer::bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name_); }

void Buffer::bindUniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_); }

} // namespace eikonal::gpu

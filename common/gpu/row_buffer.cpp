#include "common/gpu/row_buffer.h"

#include <string>
#include <utility>

#include "common/error.h"

namespace eikonal::gpu {

namespace {

constexpr std::size_t kRowBytes = 16;

void requireRows(std::size_t bytes, std::string_view label) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (bytes / kRowBytes <= std::size_t(limit)) return;
    throw badInput("buffer '" + std::string(label) + "' of " + std::to_string(bytes / kRowBytes) +
                   " rows: the device allows at most " + std::to_string(limit));
}

} // namespace

RowBuffer::RowBuffer(const Context& context, std::size_t bytes, std::string_view label) : Buffer(context, bytes, label) {
    requireRows(bytes, label);
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels_);
    glTextureBuffer(texels_, GL_RGBA32UI, name());
    glObjectLabel(GL_TEXTURE, texels_, GLsizei(label.size()), label.data());
}

RowBuffer::RowBuffer(RowBuffer&& other) noexcept : Buffer(std::move(other)), texels_(std::exchange(other.texels_, 0)) {}

RowBuffer& RowBuffer::operator=(RowBuffer&& other) noexcept {
    Buffer::operator=(std::move(other));
    std::swap(texels_, other.texels_);
    return *this;
}

RowBuffer::~RowBuffer() {
    if (texels_) glDeleteTextures(1, &texels_);
}

void RowBuffer::grow(std::size_t bytes) {
    requireRows(bytes, label());
    Buffer::grow(bytes);
    glTextureBuffer(texels_, GL_RGBA32UI, name());
}

void RowBuffer::bindTexels(GLuint unit) const { glBindTextureUnit(unit, texels_); }

} // namespace eikonal::gpu

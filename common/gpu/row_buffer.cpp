#include "common/gpu/row_buffer.h"

#include <string>
#include <utility>

#include "common/error.h"

namespace eikonal::gpu {

namespace {

void requireRows(std::size_t bytes, int wordsPerRow, std::string_view label) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    const std::size_t rows = bytes / (std::size_t(wordsPerRow) * sizeof(GLuint));
    if (rows <= std::size_t(limit)) return;
    throw badInput("buffer '" + std::string(label) + "' of " + std::to_string(rows) + " rows: the device allows at most " +
                   std::to_string(limit));
}

GLenum formatOf(int wordsPerRow) {
    return wordsPerRow == 1 ? GL_R32UI : wordsPerRow == 2 ? GL_RG32UI : GL_RGBA32UI;
}

} // namespace

RowBuffer::RowBuffer(const Context& context, std::size_t bytes, std::string_view label, int wordsPerRow)
    : Buffer(context, bytes, label), wordsPerRow_(wordsPerRow) {
    requireRows(bytes, wordsPerRow_, label);
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels_);
    glTextureBuffer(texels_, formatOf(wordsPerRow_), name());
    glObjectLabel(GL_TEXTURE, texels_, GLsizei(label.size()), label.data());
}

RowBuffer::RowBuffer(RowBuffer&& other) noexcept
    : Buffer(std::move(other)), wordsPerRow_(other.wordsPerRow_), texels_(std::exchange(other.texels_, 0)) {}

RowBuffer& RowBuffer::operator=(RowBuffer&& other) noexcept {
    Buffer::operator=(std::move(other));
    std::swap(wordsPerRow_, other.wordsPerRow_);
    std::swap(texels_, other.texels_);
    return *this;
}

RowBuffer::~RowBuffer() {
    if (texels_) glDeleteTextures(1, &texels_);
}

void RowBuffer::grow(std::size_t bytes) {
    requireRows(bytes, wordsPerRow_, label());
    Buffer::grow(bytes);
    glTextureBuffer(texels_, formatOf(wordsPerRow_), name());
}

void RowBuffer::bindTexels(GLuint unit) const { glBindTextureUnit(unit, texels_); }

} // namespace eikonal::gpu

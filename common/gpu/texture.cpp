#include "common/gpu/objects.h"

#include <algorithm>
#include <utility>

#include "common/error.h"

namespace eikonal::gpu {

namespace {

struct FormatTraits {
    GLenum internal, external, type;
    std::size_t texelBytes;
};

FormatTraits traitsOf(TexelFormat format) {
    switch (format) {
        case TexelFormat::kR8: return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
        case TexelFormat::kR32f: return {GL_R32F, GL_RED, GL_FLOAT, 4};
        case TexelFormat::kRgba32f: break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
}

void setLinearSampling(GLuint texture, GLint wrapU) {
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, wrapU);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

int max2dSize() {
    GLint size = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size;
}

Error tooLarge(std::string_view label, const std::string& found, int limit) {
    return badInput("texture '" + std::string(label) + "' of " + found + " texels: the device allows at most " +
                    std::to_string(limit) + " along a side");
}

} // namespace

Texture3D::Texture3D(const Context& context, TexelFormat format, const glm::ivec3& size, std::string_view label)
    : format_(format), size_(size), label_(label) {
    const int limit = context.limits().maxTexture3dSize;
    if (std::max({size.x, size.y, size.z}) > limit) {
        throw tooLarge(label, std::to_string(size.x) + " x " + std::to_string(size.y) + " x " + std::to_string(size.z),
                       limit);
    }
    glCreateTextures(GL_TEXTURE_3D, 1, &name_);
    glTextureStorage3D(name_, 1, traitsOf(format).internal, size.x, size.y, size.z);
    setLinearSampling(name_, GL_CLAMP_TO_EDGE);
    glObjectLabel(GL_TEXTURE, name_, GLsizei(label_.size()), label_.data());
}

Texture3D::Texture3D(Texture3D&& other) noexcept
    : name_(std::exchange(other.name_, 0)), format_(other.format_), size_(other.size_), label_(std::move(other.label_)) {}

Texture3D& Texture3D::operator=(Texture3D&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
    std::swap(label_, other.label_);
    return *this;
}

Texture3D::~Texture3D() {
    if (name_) glDeleteTextures(1, &name_);
}

void Texture3D::upload(const void* texels) {
    const FormatTraits traits = traitsOf(format_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage3D(name_, 0, 0, 0, 0, size_.x, size_.y, size_.z, traits.external, traits.type, texels);
}

void Texture3D::bind(GLuint unit) const { glBindTextureUnit(unit, name_); }

std::size_t Texture3D::bytes() const {
    return std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z) * traitsOf(format_).texelBytes;
}

Texture2D::Texture2D(const Context&, TexelFormat format, const glm::ivec2& size, std::string_view label)
    : format_(format), size_(size), label_(label) {
    if (const int limit = max2dSize(); std::max(size.x, size.y) > limit) {
        throw tooLarge(label, std::to_string(size.x) + " x " + std::to_string(size.y), limit);
    }
    glCreateTextures(GL_TEXTURE_2D, 1, &name_);
    glTextureStorage2D(name_, 1, traitsOf(format).internal, size.x, size.y);
    setLinearSampling(name_, GL_REPEAT);
    glObjectLabel(GL_TEXTURE, name_, GLsizei(label_.size()), label_.data());
}

Texture2D::Texture2D(Texture2D&& other) noexcept
    : name_(std::exchange(other.name_, 0)), format_(other.format_), size_(other.size_), label_(std::move(other.label_)) {}

Texture2D& Texture2D::operator=(Texture2D&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
    std::swap(label_, other.label_);
    return *this;
}

Texture2D::~Texture2D() {
    if (name_) glDeleteTextures(1, &name_);
}

void Texture2D::upload(const void* texels) {
    const FormatTraits traits = traitsOf(format_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name_, 0, 0, 0, size_.x, size_.y, traits.external, traits.type, texels);
}

void Texture2D::bind(GLuint unit) const { glBindTextureUnit(unit, name_); }

std::size_t Texture2D::bytes() const {
    return std::size_t(size_.x) * std::size_t(size_.y) * traitsOf(format_).texelBytes;
}

} // namespace eikonal::gpu

#include "common/gpu/objects.h"

#include <algorithm>
#include <bit>
#include <string>
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
        case TexelFormat::kRgba8: return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case TexelFormat::kRg16: return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4};
        case TexelFormat::kR32f: return {GL_R32F, GL_RED, GL_FLOAT, 4};
        case TexelFormat::kRgba32f: break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
}

/// Down to a single texel.
template <int kDimensions>
int levelsOf(const glm::vec<kDimensions, int>& size) {
    int levels = 1;
    for (int axis = 0; axis < kDimensions; ++axis) levels = std::max(levels, int(std::bit_width(unsigned(size[axis]))));
    return levels;
}

void setLinearSampling(GLuint texture, GLint wrapU, int levels) {
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, wrapU);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

int largestSize(const Context& context, int dimensions) {
    if (dimensions == 3) return context.limits().maxTexture3dSize;
    GLint size = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size;
}

template <int kDimensions>
void requireSize(const Context& context, const glm::vec<kDimensions, int>& size, std::string_view label) {
    const int limit = largestSize(context, kDimensions);
    if (glm::all(glm::lessThanEqual(size, glm::vec<kDimensions, int>(limit)))) return;
    std::string found;
    for (int axis = 0; axis < kDimensions; ++axis) found += (axis > 0 ? " x " : "") + std::to_string(size[axis]);
    throw badInput("texture '" + std::string(label) + "' of " + found + " texels: the device allows at most " +
                   std::to_string(limit) + " along a side");
}

} // namespace

template <int kDimensions>
Texture<kDimensions>::Texture(const Context& context, TexelFormat format, const Size& size, std::string_view label,
                              bool hasMeans)
    : format_(format), size_(size), levels_(hasMeans ? levelsOf<kDimensions>(size) : 1), label_(label) {
    requireSize<kDimensions>(context, size, label);
    const GLenum internal = traitsOf(format).internal;
    if constexpr (kDimensions == 3) {
        glCreateTextures(GL_TEXTURE_3D, 1, &name_);
        glTextureStorage3D(name_, levels_, internal, size.x, size.y, size.z);
        setLinearSampling(name_, GL_CLAMP_TO_EDGE, levels_);
    } else {
        glCreateTextures(GL_TEXTURE_2D, 1, &name_);
        glTextureStorage2D(name_, levels_, internal, size.x, size.y);
        setLinearSampling(name_, GL_REPEAT, levels_);
    }
    glObjectLabel(GL_TEXTURE, name_, GLsizei(label_.size()), label_.data());
}

template <int kDimensions>
Texture<kDimensions>::Texture(Texture&& other) noexcept
    : name_(std::exchange(other.name_, 0)), format_(other.format_), size_(other.size_), levels_(other.levels_),
      label_(std::move(other.label_)) {}

template <int kDimensions>
Texture<kDimensions>& Texture<kDimensions>::operator=(Texture&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
    std::swap(levels_, other.levels_);
    std::swap(label_, other.label_);
    return *this;
}

template <int kDimensions>
Texture<kDimensions>::~Texture() {
    if (name_) glDeleteTextures(1, &name_);
}

template <int kDimensions>
void Texture<kDimensions>::upload(const void* texels) {
    const FormatTraits traits = traitsOf(format_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if constexpr (kDimensions == 3) {
        glTextureSubImage3D(name_, 0, 0, 0, 0, size_.x, size_.y, size_.z, traits.external, traits.type, texels);
    } else {
        glTextureSubImage2D(name_, 0, 0, 0, size_.x, size_.y, traits.external, traits.type, texels);
    }
}

template <int kDimensions>
void Texture<kDimensions>::fillMeans() {
    glGenerateTextureMipmap(name_);
}

template <int kDimensions>
void Texture<kDimensions>::showGrey() {
    glTextureParameteri(name_, GL_TEXTURE_SWIZZLE_G, GL_RED);
    glTextureParameteri(name_, GL_TEXTURE_SWIZZLE_B, GL_RED);
    glTextureParameteri(name_, GL_TEXTURE_SWIZZLE_A, GL_ZERO);
}

template <int kDimensions>
void Texture<kDimensions>::bind(GLuint unit) const {
    glBindTextureUnit(unit, name_);
}

template <int kDimensions>
void Texture<kDimensions>::bindImage(GLuint unit) const {
    glBindImageTexture(unit, name_, 0, GL_TRUE, 0, GL_READ_WRITE, traitsOf(format_).internal);
}

template <int kDimensions>
std::size_t Texture<kDimensions>::bytes() const {
    std::size_t texels = 0;
    for (int level = 0; level < levels_; ++level) {
        std::size_t count = 1;
        for (int axis = 0; axis < kDimensions; ++axis) count *= std::size_t(std::max(size_[axis] >> level, 1));
        texels += count;
    }
    return texels * traitsOf(format_).texelBytes;
}

template class Texture<2>;
template class Texture<3>;

} // namespace eikonal::gpu

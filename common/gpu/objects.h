#pragma once
// Move-only GPU objects: direct state access, immutable storage, a debug label each. Each needs the context that it was
// created from to be current and alive until it is gone.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include "common/gpu/context.h"

namespace eikonal::gpu {

/// A buffer of fixed size (0 is allowed), usable as storage or uniform block or as source of indirect dispatches.
class Buffer {
public:
    Buffer(const Context& context, std::size_t bytes, std::string_view label);
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    std::size_t bytes() const { return bytes_; }
    GLuint name() const { return name_; }
    const std::string& label() const { return label_; }
    void uploadBytes(std::size_t offset, const void* data, std::size_t bytes);
    void downloadBytes(std::size_t offset, void* data, std::size_t bytes) const;
    /// Makes it at least so large, in another place. What it holds stays.
    void grow(std::size_t bytes);
    /// Fills the whole buffer with a 32-bit value.
    void fill(std::uint32_t value);
    void bindStorage(GLuint binding) const;
    void bindUniform(GLuint binding) const;

    template <class T>
    void upload(std::span<const T> values) { uploadBytes(0, values.data(), values.size_bytes()); }
    template <class T>
    void upload(const T& value) { uploadBytes(0, &value, sizeof value); }
    template <class T>
    std::vector<T> download(std::size_t count) const {
        std::vector<T> values(count);
        downloadBytes(0, values.data(), count * sizeof(T));
        return values;
    }

private:
    Transfer* transfer_ = nullptr;
    std::string label_;
    GLuint name_ = 0;
    std::size_t bytes_ = 0;
};

enum class TexelFormat { kR8, kRgba8, kRg16, kRgba32f, kR32f };

/// A texture with linear filtering, of one level unless means over ever larger squares are wanted. Volumes are clamped at
/// their faces; images repeat along u and are clamped along v (latitude-longitude maps). Throws badInput if the size is
/// beyond the device.
template <int kDimensions>
class Texture {
public:
    using Size = glm::vec<kDimensions, int>;

    Texture(const Context& context, TexelFormat format, const Size& size, std::string_view label, bool hasMeans = false);
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;
    ~Texture();

    /// Tightly packed texels of the texture's own format (R8, RG8, RGBA8: bytes, RG16: 16-bit words, others: floats), x fastest.
    void upload(const void* texels);
    /// The other levels, from the first.
    void fillMeans();
    /// Reads of a texture of one channel give its value in red, green and blue, and 0 in alpha.
    void showGrey();
    void bind(GLuint unit) const;
    /// For kernels that store texels.
    void bindImage(GLuint unit) const;
    const Size& size() const { return size_; }
    GLuint name() const { return name_; }
    std::size_t bytes() const;
    const std::string& label() const { return label_; }

private:
    GLuint name_ = 0;
    TexelFormat format_{};
    Size size_{0};
    int levels_ = 1;
    std::string label_;
};

using Texture2D = Texture<2>;
using Texture3D = Texture<3>;

/// A compute kernel compiled from shaders/ with a set of #defines. A compile error is a broken program: std::logic_error
/// with the log.
class Kernel {
public:
    Kernel(const Context& context, std::string_view shaderName, const std::vector<std::string>& defines);
    Kernel(Kernel&& other) noexcept;
    Kernel& operator=(Kernel&& other) noexcept;
    ~Kernel();

    /// Ends with a barrier: whatever it wrote is visible to what follows, dispatches, indirect arguments and downloads.
    void dispatch(const glm::uvec3& groups) const;
    /// The same with the groups from three 32-bit words at `offset`.
    void dispatchIndirect(const Buffer& arguments, std::size_t offset) const;
    /// The same of several kernels, none of which reads what another one writes: the device may run them at once.
    struct Indirect {
        const Kernel& kernel;
        std::size_t offset;
    };
    static void dispatchTogether(const Buffer& arguments, std::initializer_list<Indirect> dispatches);
    GLuint name() const { return name_; }
    /// How many it has, where the driver tells.
    std::optional<std::size_t> instructions() const;

private:
    GLuint name_ = 0;
};

} // namespace eikonal::gpu

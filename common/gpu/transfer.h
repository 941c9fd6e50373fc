#pragma once
// The way of data between this program and buffers: through two buffers that stay mapped, from which and into which the device
// copies in the order of commands. Drivers may carry out a large glNamedBufferSubData before commands that were given earlier and
// read the buffer, as long as these have not been flushed (seen with NVIDIA's, 580.159).

#include <array>
#include <cstddef>

#include <epoxy/gl.h>

namespace eikonal::gpu {

/// Of one context, which must be current; the buffers go with it.
class Transfer {
public:
    Transfer();
    Transfer(const Transfer&) = delete;
    Transfer& operator=(const Transfer&) = delete;

    /// Commands before this see the buffer as it was, later ones as it will be.
    void upload(GLuint buffer, std::size_t offset, const void* data, std::size_t bytes);
    /// Waits for what earlier commands wrote.
    void download(GLuint buffer, std::size_t offset, void* data, std::size_t bytes);

private:
    static constexpr std::size_t kSegments = 4;  // of what is on its way up: one is filled while others are copied

    void enterNextSegment();

    GLuint up_ = 0, down_ = 0;
    std::byte* mappedUp_ = nullptr;
    const std::byte* mappedDown_ = nullptr;
    std::size_t segment_ = 0;
    std::size_t filled_ = 0;  // bytes of the segment
    std::array<GLsync, kSegments> copied_{};
};

} // namespace eikonal::gpu

#include "common/gpu/transfer.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "common/error.h"

namespace eikonal::gpu {

namespace {

constexpr std::size_t kSegmentBytes = std::size_t(1) << 20;
constexpr std::size_t kDownBytes = std::size_t(4) << 20;
constexpr std::size_t kAlignment = 64;
constexpr GLuint64 kPatience = 1'000'000'000;  // [ns] between two looks whether the device is done

GLuint mappedBuffer(std::size_t bytes, GLbitfield access, std::string_view label, std::byte*& mapped) {
    const GLbitfield flags = access | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, GLsizeiptr(bytes), nullptr, flags | GL_CLIENT_STORAGE_BIT);
    glObjectLabel(GL_BUFFER, name, GLsizei(label.size()), label.data());
    mapped = static_cast<std::byte*>(glMapNamedBufferRange(name, 0, GLsizeiptr(bytes), flags));
    if (mapped == nullptr) throw Error(ExitCode::kNoDevice, "the device maps no memory for transfers");
    return name;
}

void waitFor(GLsync& fence) {
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience) == GL_TIMEOUT_EXPIRED) {}
    glDeleteSync(fence);
    fence = nullptr;
}

} // namespace

Transfer::Transfer() {
    std::byte* mapped = nullptr;
    up_ = mappedBuffer(kSegments * kSegmentBytes, GL_MAP_WRITE_BIT, "uploads", mapped);
    mappedUp_ = mapped;
    down_ = mappedBuffer(kDownBytes, GL_MAP_READ_BIT, "downloads", mapped);
    mappedDown_ = mapped;
}

void Transfer::enterNextSegment() {
    copied_[segment_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    segment_ = (segment_ + 1) % kSegments;
    filled_ = 0;
    if (copied_[segment_] != nullptr) waitFor(copied_[segment_]);
}

void Transfer::upload(GLuint buffer, std::size_t offset, const void* data, std::size_t bytes) {
    const auto* source = static_cast<const std::byte*>(data);
    for (std::size_t done = 0; done < bytes;) {
        if (filled_ >= kSegmentBytes) enterNextSegment();
        const std::size_t part = std::min(bytes - done, kSegmentBytes - filled_);
        const std::size_t from = segment_ * kSegmentBytes + filled_;
        std::memcpy(mappedUp_ + from, source + done, part);
        glCopyNamedBufferSubData(up_, buffer, GLintptr(from), GLintptr(offset + done), GLsizeiptr(part));
        done += part;
        filled_ += (part + kAlignment - 1) / kAlignment * kAlignment;
    }
}

void Transfer::download(GLuint buffer, std::size_t offset, void* data, std::size_t bytes) {
    auto* target = static_cast<std::byte*>(data);
    for (std::size_t done = 0; done < bytes;) {
        const std::size_t part = std::min(bytes - done, kDownBytes);
        glCopyNamedBufferSubData(buffer, down_, GLintptr(offset + done), 0, GLsizeiptr(part));
        GLsync copied = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        waitFor(copied);
        std::memcpy(target + done, mappedDown_, part);
        done += part;
    }
}

} // namespace eikonal::gpu

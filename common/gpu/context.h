#pragma once
// An OpenGL 4.5 core context. GPU objects are created from one that is passed in and are gone before it.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace eikonal::gpu {

/// What the device allows, read once when the context is made.
struct DeviceLimits {
    std::size_t maxStorageBlockBytes = 0;
    int maxTexture3dSize = 0;
    bool isProcessor = false;          ///< a software renderer: vectors of a few invocations, and a processor's caches
    bool exactLinearFiltering = true;  ///< false: the texture unit weights with fewer bits than a float; filter by hand
};

struct ContextOptions {
    bool asHardware = false;  ///< divide work as for a GPU, whatever renders
    bool forceManualFiltering = false;  ///< behave as on a device whose linear filtering is not exact
    std::filesystem::path shaderFolder;  ///< where shaders are read in place of those in the program; empty: nowhere
};

class Transfer;

class Context {
public:
    /// A context without a window: EGL on a hardware device, then surfaceless, then any device, then the default display.
    /// Throws Error(kNoDevice) that says what was found when none gives OpenGL 4.5 core.
    static Context windowless(const ContextOptions& options = {});
    /// The context that is current on this thread and belongs to someone else, a window say, who outlives this.
    /// `makeCurrent` makes it current again. Throws Error(kNoDevice) if it is older than 4.5.
    static Context ofCurrent(std::function<void()> makeCurrent, const ContextOptions& options = {});

    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    /// Makes this the context of the thread again, after another one was made on it.
    void makeCurrent() const;
    const DeviceLimits& limits() const;
    const std::filesystem::path& shaderFolder() const;
    Transfer& transfer() const;  ///< how data reach buffers and come back; stays where it is when the context is moved
    std::string rendererName() const;  ///< GL_RENDERER and version
    /// Throws Error(kFailure) with the messages if the debug callback has seen a GL error since the last call.
    void throwIfError() const;

private:
    struct Impl;
    explicit Context(std::unique_ptr<Impl> impl);
    static Context adopt(std::function<void()> makeCurrent, std::function<void()> destroy, const ContextOptions& options);
    std::unique_ptr<Impl> impl_;
};

} // namespace eikonal::gpu

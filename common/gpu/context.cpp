// What every context has, whoever made it: limits, and the errors that the debug callback has seen.
#include "common/gpu/context.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "common/error.h"
#include "common/gpu/objects.h"
#include "common/gpu/transfer.h"

namespace eikonal::gpu {

struct Context::Impl {
    std::function<void()> makeCurrent, destroy;
    DeviceLimits limits;
    std::filesystem::path shaderFolder;
    std::vector<std::string> errors;
    std::unique_ptr<Transfer> transfer;

    ~Impl() {
        if (destroy) destroy();
    }
};

namespace {

constexpr int kProbes = 1024;
constexpr float kExactFiltering = 1e-5f;
constexpr std::size_t kMostErrorsKept = 16;

void GLAPIENTRY collectError(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* message,
                             const void* user) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    auto& errors = *static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    if (errors.size() < kMostErrorsKept) errors.emplace_back(message, std::size_t(length));
}

DeviceLimits queriedLimits(bool asHardware) {
    DeviceLimits limits;
    GLint64 blockBytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &blockBytes);
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limits.maxTexture3dSize);
    limits.maxStorageBlockBytes = std::size_t(blockBytes);
    const std::string_view renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    limits.isProcessor = !asHardware && (renderer.starts_with("llvmpipe") || renderer.starts_with("softpipe"));
    return limits;
}

/// Whether the texture unit interpolates with the precision of a float, measured.
bool filtersExactly(const Context& context) {
    Texture3D ramp(context, TexelFormat::kR32f, {2, 1, 1}, "filtering probe");
    const std::array<float, 2> texels = {0.0f, 1.0f};
    ramp.upload(texels.data());
    ramp.bind(0);
    Buffer values(context, kProbes * sizeof(float), "filtering probe values");
    values.bindStorage(0);
    Kernel(context, "gpu/linear_filtering.comp.glsl", {}).dispatch({kProbes / 64, 1, 1});
    const auto sampled = values.download<float>(kProbes);
    for (int i = 0; i < kProbes; ++i) {
        if (!(std::abs(sampled[std::size_t(i)] - float(i) / float(kProbes)) <= kExactFiltering)) return false;
    }
    return true;
}

} // namespace

Context Context::adopt(std::function<void()> makeCurrent, std::function<void()> destroy, const ContextOptions& options) {
    auto impl = std::make_unique<Impl>();
    impl->makeCurrent = std::move(makeCurrent);
    impl->destroy = std::move(destroy);
    impl->shaderFolder = options.shaderFolder;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(collectError, &impl->errors);
    // A shader that does not compile is told by its status, and may be wrong input (ContextOptions::shaderFolder).
    glDebugMessageControl(GL_DEBUG_SOURCE_SHADER_COMPILER, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    impl->limits = queriedLimits(options.asHardware);
    impl->transfer = std::make_unique<Transfer>();
    Context context(std::move(impl));
    context.impl_->limits.exactLinearFiltering = !options.forceManualFiltering && filtersExactly(context);
    context.throwIfError();
    return context;
}

Context Context::ofCurrent(std::function<void()> makeCurrent, const ContextOptions& options) {
    if (epoxy_gl_version() < 45) {
        throw Error(ExitCode::kNoDevice,
                    "expected OpenGL 4.5 in the window, found " + std::to_string(epoxy_gl_version() / 10) + "." +
                        std::to_string(epoxy_gl_version() % 10));
    }
    return adopt(std::move(makeCurrent), {}, options);
}

Context::Context(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::makeCurrent() const { impl_->makeCurrent(); }

const DeviceLimits& Context::limits() const { return impl_->limits; }

const std::filesystem::path& Context::shaderFolder() const { return impl_->shaderFolder; }

Transfer& Context::transfer() const { return *impl_->transfer; }

std::string Context::rendererName() const {
    const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void Context::throwIfError() const {
    std::string report;
    for (const auto& message : impl_->errors) report += "\n  " + message;
    impl_->errors.clear();
    if (!report.empty()) throw failure("OpenGL reports errors:" + report);
}

} // namespace eikonal::gpu

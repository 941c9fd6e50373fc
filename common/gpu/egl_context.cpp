// Contexts without a window. epoxy aborts the process when it is asked for an entry point that no library offers, so that
// libEGL and the client extensions are asked first.
#include "common/gpu/context.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "common/error.h"
#include "common/gpu/objects.h"

namespace eikonal::gpu {

struct Context::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    DeviceLimits limits;
    std::vector<std::string> errors;

    // The display stays initialised: EGL hands the same one to every context of the process.
    ~Impl() {
        if (eglGetCurrentContext() == context) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
    }
};

namespace {

constexpr int kProbes = 1024;
constexpr float kExactFiltering = 1e-5f;
constexpr std::size_t kMostErrorsKept = 16;

struct Candidate {
    EGLDisplay display;
    std::string name;
};

bool contains(const char* extensions, std::string_view name) {
    return extensions && std::string_view(extensions).find(name) != std::string_view::npos;
}

void addDevices(const char* extensions, bool software, std::vector<Candidate>& candidates) {
    if (!contains(extensions, "EGL_EXT_platform_device") || !contains(extensions, "EGL_EXT_device_enumeration")) return;
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) return;
    for (EGLint i = 0; i < count; ++i) {
        const char* deviceExtensions = eglQueryDeviceStringEXT(devices[std::size_t(i)], EGL_EXTENSIONS);
        if (contains(deviceExtensions, "EGL_MESA_device_software") != software) continue;
        candidates.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr),
                              "EGL device " + std::to_string(i)});
    }
}

/// Displays to try, best first: hardware devices, Mesa's surfaceless platform, software devices, the default display.
std::vector<Candidate> candidateDisplays() {
    std::vector<Candidate> candidates;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (contains(extensions, "EGL_EXT_platform_base")) {
        addDevices(extensions, false, candidates);
        if (contains(extensions, "EGL_MESA_platform_surfaceless")) {
            candidates.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr),
                                  "EGL surfaceless"});
        }
        addDevices(extensions, true, candidates);
    }
    candidates.push_back({eglGetDisplay(EGL_DEFAULT_DISPLAY), "EGL default display"});
    return candidates;
}

/// An OpenGL 4.5 core context, current, or nothing and the reason appended to `report`.
std::optional<EGLContext> contextOn(const Candidate& candidate, std::string& report) {
    const auto refuse = [&](const std::string& reason) {
        report += "\n  " + candidate.name + ": " + reason;
        return std::nullopt;
    };
    EGLint major = 0, minor = 0;
    if (candidate.display == EGL_NO_DISPLAY) return refuse("no display");
    if (!eglInitialize(candidate.display, &major, &minor)) return refuse("does not initialise");
    const std::string version = "EGL " + std::to_string(major) + "." + std::to_string(minor) + ", " +
                                eglQueryString(candidate.display, EGL_VENDOR);
    if (!eglBindAPI(EGL_OPENGL_API)) return refuse(version + ", no OpenGL");
    if (!contains(eglQueryString(candidate.display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
        return refuse(version + ", needs a surface");
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
    const EGLContext context = eglCreateContext(candidate.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return refuse(version + ", refuses OpenGL 4.5 core");
    if (!eglMakeCurrent(candidate.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(candidate.display, context);
        return refuse(version + ", cannot use a context without a surface");
    }
    return context;
}

void GLAPIENTRY collectError(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* message,
                             const void* user) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    auto& errors = *static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    if (errors.size() < kMostErrorsKept) errors.emplace_back(message, std::size_t(length));
}

DeviceLimits queriedLimits() {
    DeviceLimits limits;
    GLint64 blockBytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &blockBytes);
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limits.maxTexture3dSize);
    limits.maxStorageBlockBytes = std::size_t(blockBytes);
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

Context Context::windowless(const ContextOptions& options) {
    if (!epoxy_has_egl()) throw Error(ExitCode::kNoDevice, "no OpenGL 4.5 context: libEGL is not installed");
    std::string report;
    for (const Candidate& candidate : candidateDisplays()) {
        const auto made = contextOn(candidate, report);
        if (!made) continue;
        auto impl = std::make_unique<Impl>();
        impl->display = candidate.display;
        impl->context = *made;
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(collectError, &impl->errors);
        impl->limits = queriedLimits();
        Context context(std::move(impl));
        context.impl_->limits.exactLinearFiltering = !options.forceManualFiltering && filtersExactly(context);
        context.throwIfError();
        return context;
    }
    throw Error(ExitCode::kNoDevice, "no OpenGL 4.5 core context; tried:" + report);
}

Context::Context(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::makeCurrent() const {
    eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context);
}

const DeviceLimits& Context::limits() const { return impl_->limits; }

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

// Contexts without a window. epoxy aborts the process when it is asked for an entry point that no library offers, so that
// libEGL and the client extensions are asked first.
#include "common/gpu/context.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "common/error.h"

namespace eikonal::gpu {

namespace {

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

void destroy(EGLDisplay display, EGLContext context) {
    if (eglGetCurrentContext() == context) {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
}

} // namespace

Context Context::windowless(const ContextOptions& options) {
    if (!epoxy_has_egl()) throw Error(ExitCode::kNoDevice, "no OpenGL 4.5 context: libEGL is not installed");
    std::string report;
    for (const Candidate& candidate : candidateDisplays()) {
        const auto context = contextOn(candidate, report);
        if (!context) continue;
        // The display stays initialised: EGL hands the same one to every context of the process.
        const EGLDisplay display = candidate.display;
        const EGLContext made = *context;
        return adopt([=] { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made); },
                     [=] { destroy(display, made); }, options);
    }
    throw Error(ExitCode::kNoDevice, "no OpenGL 4.5 core context; tried:" + report);
}

} // namespace eikonal::gpu

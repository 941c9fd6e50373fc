#include "viewer/window/window.h"

#include <array>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "common/error.h"
#include "viewer/window/key_names.h"

namespace eikonal::window {

namespace {

std::string lastGlfwError() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? description : "no reason given";
}

Window& windowOf(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

void installCallbacks(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        windowOf(w).push({.kind = EventKind::kCursor, .at = windowOf(w).pixelOf({x, y})});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        constexpr std::array<const char*, 3> kNames{"left", "right", "middle"};
        if (button < 0 || button > 2) return;
        windowOf(w).push({.kind = EventKind::kButton, .name = kNames[std::size_t(button)], .down = action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) {
        windowOf(w).push({.kind = EventKind::kScroll, .at = {notches, 0.0}});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        const std::string name = keyName(key);
        if (name.empty() || action == GLFW_REPEAT) return;
        windowOf(w).push({.kind = EventKind::kKey, .name = name, .down = action == GLFW_PRESS});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
        if (character <= ' ' || character >= 127) return;  // numbers and names of files, as the panel takes them
        windowOf(w).push({.kind = EventKind::kText, .name = std::string(1, char(character))});
    });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int iconified) {
        windowOf(w).push({.kind = iconified == GLFW_TRUE ? EventKind::kMinimise : EventKind::kRestore});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
        for (int i = 0; i < count; ++i) windowOf(w).push({.kind = EventKind::kDrop, .name = files[i]});
    });
}

/// EGL where it is offered: the light's context without a window is made by it too.
GLFWwindow* openWindow(const glm::ivec2& size, const std::string& title) {
    for (const int api : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        if (GLFWwindow* window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr)) return window;
    }
    return nullptr;
}

} // namespace

Window::Window(const glm::ivec2& size, const std::string& title, const gpu::ContextOptions& options) {
    if (!glfwInit()) throw Error(ExitCode::kNoDevice, "no window: expected a display to open one on: " + lastGlfwError());
    window_ = openWindow(size, title);
    if (!window_) {
        const std::string reason = lastGlfwError();
        glfwTerminate();
        throw Error(ExitCode::kNoDevice, "no window with OpenGL 4.5 core: " + reason);
    }
    glfwSetWindowUserPointer(window_, this);
    installCallbacks(window_);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    context_.emplace(gpu::Context::ofCurrent([window = window_] { glfwMakeContextCurrent(window); }, options));
}

Window::~Window() {
    context_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::vector<Event> Window::poll(double waitSeconds) {
    if (waitSeconds > 0.0) {
        glfwWaitEventsTimeout(waitSeconds);
    } else {
        glfwPollEvents();
    }
    return std::exchange(events_, {});
}

void Window::show() { glfwSwapBuffers(window_); }

bool Window::isClosing() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

glm::ivec2 Window::pixels() const {
    glm::ivec2 size(0);
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) return size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::dvec2 Window::pixelOf(const glm::dvec2& place) const {
    glm::ivec2 size(0);
    glfwGetWindowSize(window_, &size.x, &size.y);
    return place * glm::dvec2(pixels()) / glm::dvec2(glm::max(size, glm::ivec2(1)));
}

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void Window::resize(const glm::ivec2& size) { glfwSetWindowSize(window_, size.x, size.y); }

void Window::minimise() { glfwIconifyWindow(window_); }

void Window::restore() { glfwRestoreWindow(window_); }

void Window::toggleFullScreen() {
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.z, windowed_.w, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
    glfwGetWindowSize(window_, &windowed_.z, &windowed_.w);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

std::vector<glm::vec3> Window::screenshot() const {
    const glm::ivec2 size = pixels();
    std::vector<glm::vec3> upwards(std::size_t(size.x) * std::size_t(size.y)), rows;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_FLOAT, upwards.data());
    rows.reserve(upwards.size());
    for (int y = size.y - 1; y >= 0; --y) {
        const auto row = upwards.begin() + std::ptrdiff_t(y) * size.x;
        rows.insert(rows.end(), row, row + size.x);
    }
    return rows;
}

} // namespace eikonal::window

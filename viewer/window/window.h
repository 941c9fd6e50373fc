#pragma once
// A window of the desktop with an OpenGL 4.5 core context (GLFW), and what a person does in it as events.

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "common/gpu/context.h"
#include "viewer/window/event.h"

struct GLFWwindow;

namespace eikonal::window {

class Window {
public:
    /// Throws Error(kNoDevice) without a display or OpenGL 4.5 core.
    Window(const glm::ivec2& size, const std::string& title, const gpu::ContextOptions& options = {});
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    const gpu::Context& context() const { return *context_; }

    /// What happened since the last call; waits for something to happen, at most that long. Frames are not filled in.
    std::vector<Event> poll(double waitSeconds);
    void show();  ///< what was drawn
    bool isClosing() const;
    glm::ivec2 pixels() const;  ///< of the framebuffer; 0 while the window is minimised
    void setTitle(const std::string& title);
    void resize(const glm::ivec2& size);
    void minimise();
    void restore();
    void toggleFullScreen();
    /// What was drawn and not shown yet: rows from the top, 0 to 1.
    std::vector<glm::vec3> screenshot() const;

    void push(Event event) { events_.push_back(std::move(event)); }
    /// Pixels of the framebuffer for a place in the window's own units.
    glm::dvec2 pixelOf(const glm::dvec2& place) const;

private:
    GLFWwindow* window_ = nullptr;
    std::optional<gpu::Context> context_;
    std::vector<Event> events_;
    glm::ivec4 windowed_{0};  ///< place and size before full screen
};

} // namespace eikonal::window

#pragma once
// Dear ImGui fed with events, recorded or live, and drawn into the window.

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "viewer/window/event.h"

namespace eikonal::window {

class Gui {
public:
    /// Needs the window's context to be current, here and in all that follows.
    Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui();

    void feed(const Event& event);
    /// Widgets may be made between begin and draw.
    void begin(const glm::ivec2& pixels, double frameSeconds);
    void draw();

    bool wantsMouse() const;     ///< the pointer is on a panel or drags one of its values
    bool wantsKeyboard() const;  ///< something is being typed

private:
    void press(const Event& event);

    std::vector<std::string> pressed_;  ///< in this frame
    std::vector<Event> released_;       ///< of those: they count after the frame, or a quick click would be none
};

} // namespace eikonal::window

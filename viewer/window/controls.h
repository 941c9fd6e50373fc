#pragma once
// What is held down, and what the pointer's way means: orbit, pan, or the drag of a light.

#include <optional>
#include <set>
#include <string>

#include "viewer/window/event.h"
#include "viewer/window/orbit.h"

namespace eikonal::window {

class Controls {
public:
    enum class Drag { kNone, kOrbit, kPan, kLight };

    /// A button went down on the picture: `light` if on a light's handle. Up: any drag ends.
    void press(const Event& button, std::optional<std::size_t> light);
    void key(const Event& key);
    /// Takes the pointer to a place [pixels].
    void moveTo(const glm::dvec2& at);

    const glm::dvec2& pointer() const { return pointer_; }
    Drag drag() const { return drag_; }
    std::optional<std::size_t> light() const { return light_; }
    /// Whether the pointer is elsewhere than when this was last asked.
    bool hasMoved();
    /// The camera after the pointer's way since the last call, in a picture of that height [pixels].
    Camera dragged(const Camera& camera, double height);
    /// The camera after the keys that are held have moved it for so long; nothing where none is.
    std::optional<Camera> flown(const Camera& camera, double seconds) const;

private:
    bool isHeld(const char* key) const { return held_.contains(key); }

    std::set<std::string> held_;
    glm::dvec2 pointer_{0.0}, from_{0.0};
    Drag drag_ = Drag::kNone;
    std::optional<std::size_t> light_;
};

} // namespace eikonal::window

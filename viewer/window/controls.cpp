#include "viewer/window/controls.h"

namespace eikonal::window {

namespace {

constexpr double kOrbitRadians = 3.14159265358979323846;  // for a way of the picture's height
constexpr double kFlightPerSecond = 0.6;                   // of the distance to the target

} // namespace

void Controls::press(const Event& button, std::optional<std::size_t> light) {
    light_.reset();
    drag_ = Drag::kNone;
    from_ = pointer_;
    if (!button.down) return;
    if (button.name == "middle" || (button.name == "left" && isHeld("shift"))) {
        drag_ = Drag::kPan;
    } else if (button.name == "left") {
        drag_ = light ? Drag::kLight : Drag::kOrbit;
        light_ = light;
    }
}

void Controls::key(const Event& key) {
    if (key.down) {
        held_.insert(key.name);
    } else {
        held_.erase(key.name);
    }
}

void Controls::moveTo(const glm::dvec2& at) { pointer_ = at; }

bool Controls::hasMoved() {
    const bool moved = pointer_ != from_;
    from_ = pointer_;
    return moved;
}

Camera Controls::dragged(const Camera& camera, double height) {
    const glm::dvec2 way = (pointer_ - from_) / height;
    from_ = pointer_;
    if (way == glm::dvec2(0.0)) return camera;
    if (drag_ == Drag::kOrbit) return orbited(camera, glm::dvec2(-way.x, way.y) * kOrbitRadians);
    if (drag_ == Drag::kPan) return panned(camera, way);
    return camera;
}

std::optional<Camera> Controls::flown(const Camera& camera, double seconds) const {
    const glm::dvec3 way(double(isHeld("d")) - double(isHeld("a")), 0.0, double(isHeld("w")) - double(isHeld("s")));
    if (way == glm::dvec3(0.0)) return std::nullopt;
    return window::flown(camera, way * (kFlightPerSecond * seconds));
}

} // namespace eikonal::window

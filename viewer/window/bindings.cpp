#include "viewer/window/bindings.h"

#include <algorithm>
#include <array>

namespace eikonal::window {

namespace {

constexpr std::array<Binding, 16> kBindings{{
    {"enter", Action::kFrameAll, "frame everything"},
    {"1", Action::kFront, "look from the front (+z)"},
    {"3", Action::kRight, "look from the right (+x)"},
    {"7", Action::kAbove, "look from above (+y)"},
    {"f", Action::kFullScreen, "full screen"},
    {"h", Action::kKeyList, "this list"},
    {"tab", Action::kPanels, "hide or show the panels"},
    {"v", Action::kNextLook, "next way to look"},
    {"l", Action::kRays, "rays of the lights, and of the pointer"},
    {"n", Action::kFronts, "the wavefront on its way"},
    {"space", Action::kPlay, "play: lights along their keyframes, or a turn around the scene"},
    {"r", Action::kReload, "read the scene again"},
    {"p", Action::kPrintCamera, "print the camera as TOML"},
    {"f12", Action::kSaveStill, "save the refined picture as PNG and EXR"},
    {"f2", Action::kSaveScene, "save the scene as TOML"},
    {"escape", Action::kQuit, "quit"},
}};

constexpr std::array<Gesture, 6> kGestures{{
    {"left drag", "orbit"},
    {"middle or shift-left drag", "pan"},
    {"wheel", "move closer or away"},
    {"w a s d", "fly"},
    {"drag the lamp", "move the light"},
    {"drop a file", "open a scene, volume, mesh or environment map"},
}};

} // namespace

std::span<const Binding> bindings() { return kBindings; }

std::span<const Gesture> gestures() { return kGestures; }

const Binding* bindingOf(std::string_view key) {
    const auto found = std::find_if(kBindings.begin(), kBindings.end(), [&](const Binding& b) { return b.key == key; });
    return found == kBindings.end() ? nullptr : &*found;
}

} // namespace eikonal::window

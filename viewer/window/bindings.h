#pragma once
// The one table of keys: what a key does, and the list that H shows.

#include <span>
#include <string_view>

namespace eikonal::window {

enum class Action {
    kFrameAll, kFront, kRight, kAbove, kFullScreen, kKeyList, kPanels, kSaveStill, kPrintCamera, kReload, kPlay, kSaveScene,
    kNextLook, kRays, kFronts, kQuit
};

struct Binding {
    std::string_view key;  ///< as recordings name it
    Action action;
    std::string_view text;
};

std::span<const Binding> bindings();

/// What the mouse does, and keys that act while they are held, for the list.
struct Gesture {
    std::string_view how, text;
};
std::span<const Gesture> gestures();

/// The action of a key, or nullptr.
const Binding* bindingOf(std::string_view key);

} // namespace eikonal::window

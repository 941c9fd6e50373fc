#pragma once
// Names of keys, as recordings and the table of bindings have them.

#include <string>

namespace eikonal::window {

/// "a", "7", "enter", "f12", ... for a key of GLFW; empty for one that nothing uses.
std::string keyName(int glfwKey);

/// The key of a name, or -1.
int keyOf(const std::string& name);

} // namespace eikonal::window

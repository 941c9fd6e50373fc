#include "viewer/window/key_names.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace eikonal::window {

namespace {

constexpr std::array<std::pair<int, std::string_view>, 20> kNamed{{
    {GLFW_KEY_SPACE, "space"},
    {GLFW_KEY_ENTER, "enter"},
    {GLFW_KEY_KP_ENTER, "enter"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_ESCAPE, "escape"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_DELETE, "delete"},
    {GLFW_KEY_LEFT, "left"},
    {GLFW_KEY_RIGHT, "right"},
    {GLFW_KEY_UP, "up"},
    {GLFW_KEY_DOWN, "down"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
    {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_RIGHT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_CONTROL, "ctrl"},
    {GLFW_KEY_RIGHT_CONTROL, "ctrl"},
    {GLFW_KEY_LEFT_ALT, "alt"},
    {GLFW_KEY_F2, "f2"},
    {GLFW_KEY_F12, "f12"},
}};

bool isLetterOrDigit(int key) {
    return (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9);
}

} // namespace

std::string keyName(int glfwKey) {
    if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9) return std::string(1, char('0' + glfwKey - GLFW_KEY_KP_0));
    if (isLetterOrDigit(glfwKey)) return std::string(1, char(glfwKey >= GLFW_KEY_A ? glfwKey - GLFW_KEY_A + 'a' : glfwKey));
    const auto found = std::find_if(kNamed.begin(), kNamed.end(), [&](const auto& row) { return row.first == glfwKey; });
    return found == kNamed.end() ? std::string() : std::string(found->second);
}

int keyOf(const std::string& name) {
    if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + name[0] - 'a';
    if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return name[0];
    const auto found = std::find_if(kNamed.begin(), kNamed.end(), [&](const auto& row) { return row.second == name; });
    return found == kNamed.end() ? -1 : found->first;
}

} // namespace eikonal::window

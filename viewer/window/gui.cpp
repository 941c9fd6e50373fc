#include "viewer/window/gui.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include "viewer/window/key_names.h"

namespace eikonal::window {

namespace {

constexpr std::array<std::pair<ImGuiKey_, const char*>, 10> kEditingKeys{{
    {ImGuiKey_Tab, "tab"},
    {ImGuiKey_LeftArrow, "left"},
    {ImGuiKey_RightArrow, "right"},
    {ImGuiKey_Home, "home"},
    {ImGuiKey_End, "end"},
    {ImGuiKey_Delete, "delete"},
    {ImGuiKey_Backspace, "backspace"},
    {ImGuiKey_Enter, "enter"},
    {ImGuiKey_Escape, "escape"},
    {ImGuiKey_A, "a"},
}};

void setStyle() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6.0f;
    style.FrameRounding = 3.0f;
    style.Colors[ImGuiCol_WindowBg].w = 0.88f;
}

void setKey(ImGuiIO& io, const std::string& name, bool down) {
    const int key = keyOf(name);
    if (key >= 0 && key < int(std::size(io.KeysDown))) io.KeysDown[key] = down;
    if (name == "shift") io.KeyShift = down;
    if (name == "ctrl") io.KeyCtrl = down;
    if (name == "alt") io.KeyAlt = down;
}

int buttonOf(const std::string& name) { return name == "left" ? 0 : name == "right" ? 1 : 2; }

} // namespace

Gui::Gui() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // panels stand where they always stand
    for (const auto& [key, name] : kEditingKeys) io.KeyMap[key] = keyOf(name);
    setStyle();
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Gui::press(const Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.kind == EventKind::kButton) {
        io.MouseDown[buttonOf(event.name)] = event.down;
    } else {
        setKey(io, event.name, event.down);
    }
}

void Gui::feed(const Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
        case EventKind::kCursor: io.MousePos = ImVec2(float(event.at.x), float(event.at.y)); break;
        case EventKind::kScroll: io.MouseWheel += float(event.at.x); break;
        case EventKind::kButton:
        case EventKind::kKey:
            // Only while a value is typed Tab goes on to the next: else it shows panels, which would begin to type.
            if (event.down && event.name == "tab" && !wantsKeyboard()) break;
            if (event.down) pressed_.push_back(event.name);
            if (!event.down && std::find(pressed_.begin(), pressed_.end(), event.name) != pressed_.end()) {
                released_.push_back(event);
            } else {
                press(event);
            }
            break;
        case EventKind::kText: io.AddInputCharactersUTF8(event.name.c_str()); break;
        default: break;
    }
}

void Gui::begin(const glm::ivec2& pixels, double frameSeconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(float(pixels.x), float(pixels.y));
    io.DeltaTime = float(std::max(frameSeconds, 1e-4));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void Gui::draw() {
    ImGui::Render();
    glUseProgram(0);  // the backend restores the program in use, and the last one may be gone with its kernel
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    for (const Event& event : released_) press(event);
    released_.clear();
    pressed_.clear();
}

bool Gui::wantsMouse() const { return ImGui::GetIO().WantCaptureMouse; }

bool Gui::wantsKeyboard() const { return ImGui::GetIO().WantTextInput; }

} // namespace eikonal::window

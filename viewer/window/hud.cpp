#include "viewer/window/hud.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <imgui.h>

#include "viewer/window/bindings.h"
#include "viewer/window/orbit.h"
#include "viewer/window/panel.h"

namespace eikonal::window {

namespace {

constexpr ImGuiWindowFlags kOverlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs;
constexpr float kHudWidth = 290.0f;  // pixels
constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kHandleMargin = 20.0;  // pixels between a handle's middle and a panel
constexpr double kMessageHeight = 32.0; // pixels, of a line of text

void line(const char* label, const std::string& value) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(95.0f);
    ImGui::TextUnformatted(value.c_str());
}

/// Three of them fit a row, whatever they are.
std::string shortText(double value) {
    const double size = std::abs(value);
    const bool wantsExponent = size != 0.0 && (size < 1e-3 || size >= 1e3);
    return wantsExponent ? fmt::format("{:.1e}", value) : fmt::format("{:.3g}", value);
}

std::string shortTexts(const std::vector<float>& values) {
    std::string text;
    for (const float value : values) text += (text.empty() ? "" : "  ") + shortText(value);
    return text.empty() ? "-" : text;
}

/// The same rows wherever the pointer is, so that nothing below them moves.
void drawProbe(const std::optional<gpu::FilmPixel>& probe, const std::optional<SliceProbe>& slice) {
    ImGui::Separator();
    ImGui::TextDisabled("under the pointer");
    if (slice) line(slice->label.data(), shortTexts(slice->values));
    const gpu::FilmPixel pixel = probe.value_or(gpu::FilmPixel{});
    const auto row = [&](const char* label, const std::string& value) { line(label, probe ? value : "-"); };
    row("radiance", shortTexts({pixel.radiance.x, pixel.radiance.y, pixel.radiance.z}));
    row("depth", shortTexts({pixel.depth.x, pixel.depth.y, pixel.depth.z}));
    const glm::vec3& exit = pixel.exitDirection;
    row("goes to", fmt::format("{:.2f}  {:.2f}  {:.2f}", exit.x, exit.y, exit.z));
    row("steps", fmt::format("{:.0f}", pixel.steps));
}

} // namespace

glm::dvec2 drawHud(const HudState& state) {
    ImGui::SetNextWindowPos(ImVec2(10.0f, 10.0f));
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::SetNextWindowSizeConstraints(ImVec2(kHudWidth, 0.0f), ImVec2(kHudWidth, 1e4f));
    ImGui::Begin("numbers", nullptr, kOverlay);
    line("frame", fmt::format("{:.0f} ms", 1e3 * state.frameSeconds));
    line("picture", fmt::format("{} x {} of {} x {}", state.pictureSize.x, state.pictureSize.y, state.screenSize.x,
                                state.screenSize.y));
    line("samples", fmt::format("{} of {}", state.samples, state.samplesWanted));
    line("steps a ray", fmt::format("{:.1f}", state.stepsPerRay));
    for (const auto& [pass, seconds] : state.passSeconds) line(pass.c_str(), fmt::format("{:.2f} ms", 1e3 * seconds));
    line("light", state.bakeProgress ? fmt::format("{}, baking {:.0f} %", state.lightState, 100.0 * *state.bakeProgress)
                                     : state.lightState);
    line("memory", fmt::format("{:.0f} MiB", double(state.memoryBytes) / kMebibyte));
    drawProbe(state.probe, state.slice);
    ImGui::TextDisabled("H: keys");
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::End();
    return {corner.x + size.x, corner.y + size.y};
}

HandleRoom roomBesidePanels(const glm::ivec2& pixels, const glm::dvec2& numbersCorner) {
    const glm::dvec2 screen(pixels);
    HandleRoom room{.aspect = screen.x / screen.y};
    room.numbers = (numbersCorner + kHandleMargin) / screen;
    // The message's place is left free without one too, or a press that takes it away would move the handle from the pointer.
    const glm::dvec2 corner = screen - glm::dvec2(kPanelWidth, kMessageHeight) - double(kPanelGap) - kHandleMargin;
    room.highest = glm::max(room.lowest, corner / screen);
    return room;
}

void drawHandles(const Scene& scene, const Lattice& domain, const Camera& camera, const HandleRoom& room,
                 std::optional<std::size_t> highlighted) {
    // Over the picture, and under the panel, which takes clicks.
    ImDrawList* canvas = ImGui::GetForegroundDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float panelLeft = screen.x - kPanelWidth - kPanelGap;
    canvas->PushClipRect(ImVec2(0.0f, 0.0f), ImVec2(panelLeft, screen.y));
    const auto pixel = [&](const glm::dvec2& at) { return ImVec2(float(at.x) * screen.x, float(at.y) * screen.y); };
    const Projected middle = projected(camera, 0.5 * (domain.min + domain.max()), room.aspect);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto handle = handleOnScreen(scene.lights[i], domain, camera, room);
        if (!handle) continue;
        const bool bright = highlighted == i;
        const ImVec2 at = pixel(*handle);
        const float radius = bright ? 13.0f : 11.0f;
        const ImU32 yellow = IM_COL32(255, 214, 64, bright ? 255 : 220);
        if (middle.depth > 0.0) canvas->AddLine(at, pixel(middle.at), IM_COL32(255, 214, 64, bright ? 160 : 70), 1.5f);
        canvas->AddCircleFilled(at, radius, yellow, 24);
        canvas->AddCircle(at, radius, IM_COL32(40, 30, 0, 255), 24, 2.0f);
        const std::string label = bright ? "drag: the light follows" : "drag me";
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        const float right = at.x + radius + 6.0f;
        const ImVec2 place(right + size.x > panelLeft ? at.x - radius - 6.0f - size.x : right, at.y - 0.5f * size.y);
        const ImVec2 corner(place.x + size.x + 3.0f, place.y + size.y + 2.0f);
        canvas->AddRectFilled(ImVec2(place.x - 3.0f, place.y - 2.0f), corner, IM_COL32(0, 0, 0, 140), 3.0f);
        canvas->AddText(place, yellow, label.c_str());
    }
    canvas->PopClipRect();
}

void drawKeyList() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("keys", nullptr, kOverlay);
    const auto row = [](std::string_view how, std::string_view text) {
        ImGui::TextUnformatted(how.data(), how.data() + how.size());
        ImGui::SameLine(220.0f);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
    };
    for (const Gesture& gesture : gestures()) row(gesture.how, gesture.text);
    ImGui::Separator();
    for (const Binding& binding : bindings()) row(binding.key, binding.text);
    ImGui::End();
}

void drawMessage(const std::string& text, bool isError) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(10.0f, screen.y - 10.0f), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    ImGui::Begin("message", nullptr, kOverlay);
    ImGui::PushTextWrapPos(std::max(screen.x - kPanelWidth - 40.0f, 100.0f));
    if (isError) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.6f, 0.5f, 1.0f));
    ImGui::TextUnformatted(text.c_str());
    if (isError) ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
}

} // namespace eikonal::window

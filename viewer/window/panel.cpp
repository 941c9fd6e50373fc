#include "viewer/window/panel.h"

#include <algorithm>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "viewer/window/false_color.h"
#include "viewer/window/slice_probe.h"

namespace eikonal::window {

namespace {

/// Sections whose values are cheap to follow while they are dragged.
bool isLive(const std::string& section, const std::string& key) {
    return section == "camera" || section.rfind("light.", 0) == 0 || key == "exposure";
}

/// "object 0: ball" for object.0 with that name.
std::string title(const WrittenSection& section) {
    std::string text = section.path;
    std::replace(text.begin(), text.end(), '.', ' ');
    for (const auto& [key, value] : section.values) {
        if (key == "name" && value.size() > 2) text += ": " + value.substr(1, value.size() - 2);
        if (key == "type") text += ": " + value.substr(1, value.size() - 2);
    }
    return text;
}

bool isAllowed(const Scene& scene, Effect effect) {
    if (!scene.render.effects) return true;
    const auto& allowed = *scene.render.effects;
    return std::find(allowed.begin(), allowed.end(), effectName(effect)) != allowed.end();
}

void effectRow(const PanelState& state, const EffectDecision& decision, PanelAnswer& answer) {
    bool on = isAllowed(state.scene, decision.effect);
    const std::string name(effectName(decision.effect));
    const bool greyed = !decision.on && on;
    if (greyed) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (ImGui::Checkbox(name.c_str(), &on)) {
        answer.overrides.push_back(effectsOverride(state.effects, state.scene, decision.effect, on));
    }
    if (greyed) ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", decision.why.c_str());
    ImGui::SameLine(0.5f * kPanelWidth);
    if (const auto cost = state.effectCost(decision.effect)) {
        ImGui::Text("%+.0f ms a picture", 1e3 * *cost);
    } else {
        ImGui::TextDisabled(decision.on ? "cost: switch it" : "not needed here");
    }
}

void effects(const PanelState& state, PanelAnswer& answer) {
    if (!ImGui::CollapsingHeader("effects", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID("effects");  // a section may have the name of an effect
    for (const EffectDecision& decision : state.effects.decisions) effectRow(state, decision, answer);
    ImGui::PopID();
}

void sliceControls(const PanelState& state, viewer::LookSettings& look) {
    ImGui::RadioButton("x", &look.sliceAxis, 0);
    ImGui::SameLine();
    ImGui::RadioButton("y", &look.sliceAxis, 1);
    ImGui::SameLine();
    ImGui::RadioButton("z", &look.sliceAxis, 2);
    ImGui::SameLine();
    float position = float(look.slicePosition);
    ImGui::SetNextItemWidth(-1.0f);
    const float low = float(state.domain.min[look.sliceAxis]), high = float(state.domain.max()[look.sliceAxis]);
    ImGui::SliderFloat("##slice", &position, low, high, "at %.3f");
    look.slicePosition = position;
}

/// The colours from the first value to the last.
void legend() {
    constexpr int kPieces = 32;
    ImDrawList* canvas = ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, 10.0f);
    for (int i = 0; i < kPieces; ++i) {
        const glm::vec3 color = 255.0f * falseColor((float(i) + 0.5f) / kPieces);
        const ImVec2 from(corner.x + size.x * float(i) / kPieces, corner.y);
        const ImVec2 to(corner.x + size.x * float(i + 1) / kPieces, corner.y + size.y);
        canvas->AddRectFilled(from, to, IM_COL32(int(color.r), int(color.g), int(color.b), 255));
    }
    ImGui::Dummy(size);
}

void overlayControls(Overlays& overlays) {
    ImGui::Checkbox("rays of the lights, and of the pointer", &overlays.rays);
    ImGui::Checkbox("wavefront", &overlays.fronts);
    if (!overlays.fronts) return;
    ImGui::SameLine();
    ImGui::Checkbox("moves", &overlays.frontsMove);
    ImGui::SameLine();
    float percent = float(100.0 * overlays.frontTime);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::SliderFloat("##time", &percent, 0.0f, 100.0f, "at %.0f %%")) {
        overlays.frontsMove = false;
        overlays.frontTime = 0.01 * double(percent);
    }
}

void accuracyRows(const AccuracyReport& report) {
    const auto percent = [](const std::optional<double>& share) { return share ? fmt::format("{:.2g} %", 100.0 * *share) : "-"; };
    const auto seconds = [](const std::optional<double>& s) { return s ? fmt::format("{:.1f} s", *s) : "-"; };
    ImGui::TextDisabled("takes: light %s, picture %s", seconds(report.lightSeconds).c_str(), seconds(report.pictureSeconds).c_str());
    if (report.pictureError) {
        ImGui::TextDisabled("off by: light %s, picture %s", percent(report.lightError).c_str(),
                            percent(report.pictureError).c_str());
    } else {
        ImGui::TextDisabled("off by: look at 'error estimate' to see");
    }
}

void waysToLook(const PanelState& state, PanelAnswer& answer) {
    if (!ImGui::CollapsingHeader("look at", ImGuiTreeNodeFlags_DefaultOpen)) return;
    viewer::LookSettings& look = answer.look;
    const viewer::LookName& shown = viewer::kLooks[std::size_t(look.look)];
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::BeginCombo("##look", shown.name.data())) {
        for (const viewer::LookName& name : viewer::kLooks) {
            if (ImGui::Selectable(name.name.data(), name.look == look.look)) look.look = name.look;
        }
        ImGui::EndCombo();
    }
    if (isSlice(look.look)) sliceControls(state, look);
    if (look.look != viewer::Look::kImage && look.look != viewer::Look::kDirection) {
        legend();
        double range[2] = {look.lowest, look.highest};
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::DragScalarN("##range", ImGuiDataType_Double, range, 2, 0.02f, nullptr, nullptr, "%.3g");
        look.lowest = range[0];
        look.highest = range[1];
    }
    ImGui::PushTextWrapPos(0.0f);
    if (!shown.legend.empty()) ImGui::TextDisabled("%s", shown.legend.data());
    ImGui::PopTextWrapPos();
    overlayControls(answer.overlays);
}

} // namespace

std::string effectsOverride(const EffectSet& effects, const Scene& scene, Effect effect, bool on) {
    std::string list;
    for (const EffectDecision& decision : effects.decisions) {
        const bool allowed = decision.effect == effect ? on : isAllowed(scene, decision.effect);
        if (allowed) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", effectName(decision.effect));
    }
    return "render.effects=[" + list + "]";
}

void Panel::sections(const PanelState& state, PanelAnswer& answer) {
    for (const WrittenSection& section : writeSections(state.scene)) {
        const bool open = section.path.rfind("light.", 0) == 0;
        if (!ImGui::CollapsingHeader(title(section).c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) continue;
        if (section.path == "accuracy") accuracyRows(state.accuracy);
        for (std::size_t i = 0; i < section.values.size(); ++i) {
            const auto& [key, text] = section.values[i];
            const std::string path = section.path + "." + key;
            if (path == "render.effects" || path == "render.size" || key == "type" || key == "shape") continue;
            if (const auto value = edit_.row(path, key, text, section.forms[i], isLive(section.path, key))) {
                answer.overrides.push_back(path + "=" + *value);
            }
        }
    }
}

void Panel::saving(PanelAnswer& answer) {
    if (!ImGui::CollapsingHeader("save scene as")) return;
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputText("##file", &wish_.file);
    if (ImGui::Button("save")) answer.save = wish_;
    ImGui::SameLine();
    ImGui::Checkbox("its light too, as .vdb", &wish_.light);
}

PanelAnswer Panel::draw(const PanelState& state) {
    PanelAnswer answer{{}, state.look, state.overlays, {}};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x - kPanelWidth - kPanelGap, kPanelGap));
    ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0.0f), ImVec2(kPanelWidth, screen.y - 2.0f * kPanelGap));
    ImGui::Begin("scene", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoCollapse);
    waysToLook(state, answer);
    effects(state, answer);
    sections(state, answer);
    saving(answer);
    ImGui::End();
    return answer;
}

} // namespace eikonal::window

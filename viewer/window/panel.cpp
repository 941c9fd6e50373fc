#include "viewer/window/panel.h"

#include <algorithm>

#include <fmt/core.h>
#include <imgui.h>

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
    for (const EffectDecision& decision : state.effects.decisions) effectRow(state, decision, answer);
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
    const bool slices = look.look == viewer::Look::kIndex || look.look == viewer::Look::kIrradiance ||
                        look.look == viewer::Look::kDirection;
    if (slices) sliceControls(state, look);
    if (look.look != viewer::Look::kImage && look.look != viewer::Look::kDirection) {
        double range[2] = {look.lowest, look.highest};
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::DragScalarN("##range", ImGuiDataType_Double, range, 2, 0.02f, nullptr, nullptr, "%.3g");
        look.lowest = range[0];
        look.highest = range[1];
    }
    if (!shown.legend.empty()) ImGui::TextDisabled("%s", shown.legend.data());
    ImGui::Checkbox("rays of the lights, and of the pointer", &answer.rays);
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

PanelAnswer Panel::draw(const PanelState& state) {
    PanelAnswer answer{{}, state.look, state.rays};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x - kPanelWidth - 10.0f, 10.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0.0f), ImVec2(kPanelWidth, screen.y - 20.0f));
    ImGui::Begin("scene", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoCollapse);
    waysToLook(state, answer);
    effects(state, answer);
    sections(state, answer);
    ImGui::End();
    return answer;
}

} // namespace eikonal::window

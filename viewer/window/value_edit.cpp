#include "viewer/window/value_edit.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace eikonal::window {

namespace {

bool isQuoted(const std::string& text) { return text.size() >= 2 && text.front() == '"' && text.back() == '"'; }

std::string unquoted(const std::string& text) { return isQuoted(text) ? text.substr(1, text.size() - 2) : text; }

bool editFlag(std::string& text) {
    bool value = text == "true";
    if (!ImGui::Checkbox("##value", &value)) return false;
    text = value ? "true" : "false";
    return true;
}

bool editChoice(std::string& text, const ValueForm& form) {
    bool changed = false;
    if (!ImGui::BeginCombo("##value", unquoted(text).c_str())) return false;
    for (const std::string_view choice : form.choices) {
        if (ImGui::Selectable(std::string(choice).c_str(), choice == unquoted(text))) {
            text = fmt::format("\"{}\"", choice);
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool editNumbers(std::string& text, std::vector<double> numbers, bool isInteger) {
    double largest = 0.1;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    const float speed = isInteger ? 0.2f : float(0.005 * largest);
    const bool changed = ImGui::DragScalarN("##value", ImGuiDataType_Double, numbers.data(), int(numbers.size()), speed,
                                            nullptr, nullptr, isInteger ? "%.0f" : "%.4g");
    if (changed) text = textOfNumbers(numbers, isInteger);
    return changed;
}

bool editByFactors(std::string& text, double number, const ValueForm& form) {
    if (!ImGui::SliderScalar("##value", ImGuiDataType_Double, &number, &form.usual[0], &form.usual[1], "%.3g",
                             ImGuiSliderFlags_Logarithmic)) {
        return false;
    }
    text = textOfNumbers({number}, false);
    return true;
}

/// Expressions, files and lists, as TOML; applied with Enter.
bool editText(std::string& text) { return ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue); }

} // namespace

std::optional<std::vector<double>> numbersIn(const std::string& text) {
    std::string plain = text;
    if (plain.size() >= 2 && plain.front() == '[' && plain.back() == ']') plain = plain.substr(1, plain.size() - 2);
    std::replace(plain.begin(), plain.end(), ',', ' ');
    std::istringstream stream(plain);
    std::vector<double> numbers;
    for (double number = 0.0; stream >> number;) numbers.push_back(number);
    if (!stream.eof() || numbers.empty() || numbers.size() > 4) return std::nullopt;
    return numbers;
}

std::string textOfNumbers(const std::vector<double>& numbers, bool isInteger) {
    std::string list;
    for (const double number : numbers) {
        list += (list.empty() ? "" : ", ") + (isInteger ? fmt::format("{:.0f}", number) : fmt::format("{}", number));
    }
    return numbers.size() == 1 ? list : "[" + list + "]";
}

std::optional<std::string> ValueEdit::row(const std::string& path, const std::string& key, const std::string& text,
                                          const ValueForm& form, bool live) {
    ImGui::PushID(path.c_str());
    std::string edited = path_ == path ? text_ : text;
    const auto numbers = numbersIn(edited);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(key.c_str());
    ImGui::SameLine(0.36f * ImGui::GetWindowContentRegionMax().x);
    ImGui::SetNextItemWidth(-1.0f);
    bool changed = false, atOnce = live;
    if (edited == "true" || edited == "false") {
        changed = atOnce = editFlag(edited);
    } else if (!form.choices.empty()) {
        changed = atOnce = editChoice(edited, form);
    } else if (numbers && form.usual[0] < form.usual[1]) {
        changed = editByFactors(edited, numbers->front(), form);
    } else if (numbers) {
        changed = editNumbers(edited, *numbers, form.isInteger);
    } else {
        changed = atOnce = editText(edited);
    }
    const bool active = ImGui::IsItemActive(), released = ImGui::IsItemDeactivatedAfterEdit() && numbers.has_value();
    ImGui::PopID();
    if (active) {
        path_ = path;
        text_ = edited;
    } else if (path_ == path) {
        path_.clear();
    }
    return (changed && atOnce) || released ? std::optional(edited) : std::nullopt;
}

} // namespace eikonal::window

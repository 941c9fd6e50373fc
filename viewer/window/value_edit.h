#pragma once
// One value of the scene as a widget, made from its TOML text.

#include <optional>
#include <string>

#include "common/value_form.h"

namespace eikonal::window {

/// Numbers of a TOML text: "0.5", "[1, 2, 3]"; nothing for anything else or for more than four.
std::optional<std::vector<double>> numbersIn(const std::string& text);
/// The TOML text of as many numbers: one alone, more of them in brackets.
std::string textOfNumbers(const std::vector<double>& numbers, bool isInteger);

class ValueEdit {
public:
    /// A row: the key's name and a widget for its value. Returns the new TOML text once it is to be applied: at every
    /// change where `live`, else when the person lets go.
    std::optional<std::string> row(const std::string& path, const std::string& key, const std::string& text,
                                   const ValueForm& form, bool live);

private:
    std::string path_;  ///< of the value that is being edited
    std::string text_;  ///< as it is while that lasts
};

} // namespace eikonal::window

#pragma once
// Scenes from text, and the message that a bad one gets.

#include <string>
#include <vector>

#include "common/error.h"
#include "common/scene_toml.h"

namespace eikonal {

inline Scene sceneOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parseScene(text, "s.toml", ".", overrides);
}

/// The message of the badInput that `action` throws; says so where it throws none.
template <class Action>
std::string messageOf(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.code() == ExitCode::kBadInput ? error.what() : "wrong exit code: " + std::string(error.what());
    }
    return "no error";
}

inline std::string errorOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return messageOf([&] { sceneOf(text, overrides); });
}

} // namespace eikonal

#include "tools/scene_arguments.h"

#include <algorithm>
#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/accuracy.h"
#include "common/scene_toml.h"
#include "tools/terminal.h"
#include "tools/usage.h"

namespace eikonal {

namespace {

void pushOverride(SceneArguments& arguments, const char* key, const std::string& value) {
    arguments.overrides.push_back(fmt::format("{}={}", key, value));
}

std::string sizeAsArray(const std::string& text) {
    int width = 0;
    int height = 0;
    const char* end = text.data() + text.size();
    const auto [cross, widthStatus] = std::from_chars(text.data(), end, width);
    const bool hasCross = widthStatus == std::errc() && cross != end && (*cross == 'x' || *cross == 'X');
    const char* second = hasCross ? cross + 1 : end;
    const auto [stop, heightStatus] = std::from_chars(second, end, height);
    if (!hasCross || heightStatus != std::errc() || stop != end || width < 1 || height < 1) {
        throw CLI::ValidationError("--size", fmt::format("expected WxH in pixels such as 640x480, found '{}'", text));
    }
    return fmt::format("[{}, {}]", width, height);
}

std::string effectsAsArray(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        const bool isWord = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
        if (!isWord) {
            throw CLI::ValidationError("--effects", fmt::format("expected names such as refraction,absorption, found '{}'", name));
        }
        list += fmt::format("{}'{}'", list.empty() ? "" : ", ", name);
    }
    return names == std::vector<std::string>{"auto"} ? "'auto'" : "[" + list + "]";
}

} // namespace

void addSceneArguments(CLI::App& command, SceneArguments& arguments) {
    command.add_option("scene", arguments.file, "scene file (TOML), or a VDB with a grid `ior`")
        ->required()
        ->type_name("SCENE");
    command.add_option("--set", arguments.overrides, "override a value of the scene, as in --set object.0.ior=1.33")
        ->type_name("KEY.PATH=VALUE")
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            const bool valid = text.find('=') != std::string::npos && text.front() != '=';
            return valid ? std::string() : fmt::format("expected KEY.PATH=VALUE, found '{}'", text);
        });
    const auto pushEffects = [&arguments](const std::vector<std::string>& names) {
        pushOverride(arguments, "render.effects", effectsAsArray(names));
    };
    command
        .add_option_function<std::vector<std::string>>("--effects", pushEffects,
                                                       "effects that are allowed [the scene's, else all that it calls for]")
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false);
}

void addIntegerKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option) {
    const auto push = [&arguments, key = option.key](int value) {
        pushOverride(arguments, key, std::to_string(value));
    };
    command.add_option_function<int>(option.names, push, option.help)
        ->type_name(option.metavariable)
        ->check(aboveZero());
}

void addNumberKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option) {
    const auto push = [&arguments, key = option.key](double value) {
        pushOverride(arguments, key, fmt::format("{}", value));
    };
    command.add_option_function<double>(option.names, push, option.help)
        ->type_name(option.metavariable)
        ->check(aboveZero());
}

void addSizeKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option) {
    const auto push = [&arguments, key = option.key](const std::string& text) {
        pushOverride(arguments, key, sizeAsArray(text));
    };
    command.add_option_function<std::string>(option.names, push, option.help)->type_name(option.metavariable);
}

void addExplainFlag(CLI::App& command, SceneArguments& arguments) {
    command.add_flag("--explain", arguments.explain, "first tell which effects are on, why, with which grids and how many bytes");
}

void warnOfLight(const Scene& scene, Progress& progress) {
    if (const auto warning = warningOfIntegrator(scene)) {
        warnOf({*warning}, progress);
    }
}

Scene sceneOf(const SceneArguments& arguments) {
    Scene scene = loadScene(arguments.file, arguments.overrides);
    requireAvailable(scene);
    return scene;
}

} // namespace eikonal

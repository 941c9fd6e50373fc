#pragma once
// The arguments of every command that takes a scene: the file, --set, and options that stand for a key of the scene.

#include <string>
#include <vector>

#include "common/scene.h"

namespace CLI {
class App;
}

namespace eikonal {

class Progress;

struct SceneArguments {
    std::string file;
    std::vector<std::string> overrides;  ///< "key.path=value" in the order given, options for single keys last
    bool explain = false;  ///< print the table of effects first
};

/// An option that is a shorter spelling of --set for one key.
struct SceneKeyOption {
    const char* names;        ///< "--samples"
    const char* key;          ///< "render.samples"
    const char* metavariable; ///< "N"
    std::string help;         ///< with unit and default
};

void addSceneArguments(CLI::App& command, SceneArguments& arguments);
void addIntegerKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option);
void addNumberKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option);
/// WxH, as an array of two integers.
void addSizeKey(CLI::App& command, SceneArguments& arguments, const SceneKeyOption& option);

/// For commands that call explainEffects (tools/effect_table.h).
void addExplainFlag(CLI::App& command, SceneArguments& arguments);

/// Says on stderr what light is simulated without, of what the scene asks for.
void warnOfLight(const Scene& scene, Progress& progress);

/// The scene with its overrides. Throws badInput as loadScene and requireAvailable.
Scene sceneOf(const SceneArguments& arguments);

} // namespace eikonal

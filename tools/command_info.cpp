#include "tools/command_info.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "common/file_kind.h"
#include "common/scene_summary.h"
#include "common/stage_fields.h"
#include "common/vdb_io.h"
#include "tools/effect_table.h"
#include "tools/scene_arguments.h"
#include "tools/terminal.h"

namespace eikonal {

namespace {

using nlohmann::json;

struct InfoArguments {
    SceneArguments scene;
    bool asJson = false;
};

/// Numbers in six digits, lists in parentheses, text without quotes.
std::string plain(const json& value) {
    if (value.is_array()) {
        std::string text;
        for (const json& element : value) {
            text += (text.empty() ? "" : ", ") + plain(element);
        }
        return "(" + text + ")";
    }
    if (value.is_number_float()) {
        return fmt::format("{:.6g}", value.get<double>());
    }
    return value.is_string() ? value.get<std::string>() : value.is_null() ? std::string("none") : value.dump();
}

void printMetadata(const json& metadata, const std::string& indent) {
    for (const auto& [key, value] : metadata.items()) {
        const std::string text = plain(value);
        if (text.find('\n') == std::string::npos) {
            fmt::print("{}{}: {}\n", indent, key, text);
        } else {
            const auto lines = std::count(text.begin(), text.end(), '\n');
            fmt::print("{}{}: text of {} lines (shown with --json)\n", indent, key, lines);
        }
    }
}

void printVolume(const json& summary) {
    fmt::print("{}\n", plain(summary["file"]));
    printMetadata(summary["metadata"], "  ");
    for (const json& grid : summary["grids"]) {
        const json& size = grid["size"];
        fmt::print("\n{} ({}, {})\n", plain(grid["name"]), plain(grid["type"]), plain(grid["class"]));
        fmt::print("  size: {} x {} x {} voxels, {} active\n", plain(size[0]), plain(size[1]), plain(size[2]),
                   plain(grid["active_voxels"]));
        if (grid["active_voxels"] == 0) {
            continue;
        }
        fmt::print("  voxel: {}\n", plain(grid["voxel_size"]));
        fmt::print("  world box: {} to {}\n", plain(grid["world_min"]), plain(grid["world_max"]));
        fmt::print("  values: {} to {}, background {}\n", plain(grid["min"]), plain(grid["max"]),
                   plain(grid["background"]));
        printMetadata(grid["metadata"], "  ");
    }
}

/// A volume as a file, unless values are set of the scene that it makes.
bool isAboutFile(const InfoArguments& arguments) { return isVolumeFile(arguments.scene.file) && arguments.scene.overrides.empty(); }

json summaryOf(const InfoArguments& arguments, const ProgramOptions& options) {
    if (isAboutFile(arguments)) {
        return vdbSummary(arguments.scene.file);
    }
    const Scene scene = sceneOf(arguments.scene);
    const StageFields stages = composeStageFields(scene);
    Progress progress(options);
    warnOf(stages.light.fields->warnings, progress);
    return sceneSummary(scene, stages);
}

void printInset(const json& inset) {
    const json& size = inset["size"];
    fmt::print("{}: {} x {} x {} voxels of {}{}\n", plain(inset["name"]), plain(size[0]), plain(size[1]), plain(size[2]),
               plain(inset["voxel"]), inset["cut"].get<bool>() ? "; what reaches beyond the domain is not seen" : "");
}

void printScene(const json& summary) {
    const json& lattice = summary["lattice"];
    const json& size = lattice["size"];
    fmt::print("{}: {} objects, {} lights\n", plain(summary["source"]), plain(summary["objects"]),
               plain(summary["lights"]));
    fmt::print("domain: {} to {}, {} x {} x {} voxels of {}\n", plain(lattice["min"]), plain(lattice["max"]),
               plain(size[0]), plain(size[1]), plain(size[2]), plain(lattice["voxel"]));
    for (const json& inset : summary["insets"]) {
        printInset(inset);
    }
    fmt::print("grids: {:.1f} MiB\n", summary["memory_bytes"].get<double>() / (1024.0 * 1024.0));
    const json& cost = summary["cost"];
    fmt::print("estimated cost: image {} rays and {:.3g} steps, bake {:.3g} patch steps\n", plain(cost["image_rays"]),
               cost["image_steps"].get<double>(), cost["bake_patch_steps"].get<double>());
    fmt::print("hash of what a bake depends on: {}\neffects:\n{}", plain(summary["hash"]), effectTable(summary["effects"]));
}

void runInfo(const InfoArguments& arguments, const ProgramOptions& options) {
    const json summary = summaryOf(arguments, options);
    if (arguments.asJson) {
        fmt::print("{}\n", summary.dump(2));
    } else if (isAboutFile(arguments)) {
        printVolume(summary);
    } else {
        printScene(summary);
    }
}

} // namespace

void addInfoCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("info", "what a volume or a scene holds, and what a scene costs");
    auto arguments = std::make_shared<InfoArguments>();
    addSceneArguments(*command, arguments->scene);
    command->get_option("scene")->type_name("FILE")->description("a VDB or a scene (TOML)");
    command->add_flag("--json", arguments->asJson, "everything, as JSON");
    command->footer("Example:\n  eikonal info volumes/glass_sphere.toml --set domain.resolution=128");
    command->callback([arguments, &options] { runInfo(*arguments, options); });
}

} // namespace eikonal

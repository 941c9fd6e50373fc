#include "tools/command_view.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "common/error.h"
#include "common/interrupt.h"
#include "common/output_file.h"
#include "tools/bake_file.h"
#include "tools/frame_name.h"
#include "tools/scene_arguments.h"
#include "tools/terminal.h"
#include "tools/usage.h"
#include "tools/view_statistics.h"
#include "viewer/window/turntable.h"
#include "viewer/window/viewer.h"

namespace eikonal {

namespace {

struct ViewArguments {
    SceneArguments scene;
    std::string script, record, statistics, shaders, out;
    int frames = 0;
    double frameMilliseconds = 33.0;
};

std::string creator() { return fmt::format("{} {}", kCreator, kVersion); }

void runTurntable(const ViewArguments& arguments, const ProgramOptions& program) {
    if (!hasFrameNumber(arguments.out)) {
        throw Error(ExitCode::kUsage, fmt::format("--out: expected '#' for the frame's number, as in frames/####.png, found '{}'",
                                                  arguments.out));
    }
    requireWritable(frameName(arguments.out, 0));
    Progress progress(program);
    window::TurntableOptions options;
    options.file = arguments.scene.file;
    options.overrides = arguments.scene.overrides;
    options.frames = arguments.frames;
    options.nameOf = [&](int frame) { return frameName(arguments.out, frame); };
    options.creator = creator();
    options.progress = [&progress](std::string_view stage, double fraction) {
        throwIfInterrupted();
        progress.update(stage, fraction);
    };
    window::writeTurntable(options);
}

void runWindow(const ViewArguments& arguments) {
    if (!arguments.statistics.empty()) requireWritable(arguments.statistics);
    window::ViewOptions options;
    options.file = arguments.scene.file;
    // The window's size, unless --size says otherwise after it.
    options.overrides.push_back("render.size=[1280, 720]");
    options.overrides.insert(options.overrides.end(), arguments.scene.overrides.begin(), arguments.scene.overrides.end());
    options.script = arguments.script;
    options.record = arguments.record;
    options.shaders = arguments.shaders;
    options.frameSeconds = 1e-3 * arguments.frameMilliseconds;
    options.creator = creator();
    options.print = [](const std::string& line) {
        fmt::print("{}\n", line);
        std::fflush(stdout);
    };
    options.warn = warn;
    options.saveLight = [](const std::filesystem::path& file, const Scene& scene, const Fields& fields, const BakeResult& light) {
        writeBakeFile(file, scene, fields, light);
    };
    const window::ResponseRecord response = window::viewScene(options);
    if (!arguments.statistics.empty()) writeFile(arguments.statistics, viewJson(response).dump(2) + "\n");
}

} // namespace

void addViewCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("view", "a window on a scene: orbit it, drag its lights, change its values");
    auto arguments = std::make_shared<ViewArguments>();
    addSceneArguments(*command, arguments->scene);
    addSizeKey(*command, arguments->scene, {"--size", "render.size", "WxH", "pixels of the window [1280x720]"});
    command->add_option("--frame-ms", arguments->frameMilliseconds,
                        "what a frame may take while something moves, in milliseconds [33]")
        ->type_name("MS")
        ->check(aboveZero());
    command->add_option("--script", arguments->script, "replay recorded input (docs/viewer.md)")->type_name("FILE");
    command->add_option("--record", arguments->record, "write what is done in the window, to replay it")->type_name("FILE");
    command->add_option("--stats", arguments->statistics, "write how quickly the window answered, as JSON")->type_name("FILE.json");
    command->add_option("--shaders", arguments->shaders, "read kernels from this folder, and again when one changes")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    CLI::Option* frames =
        command->add_option("--frames", arguments->frames, "no window: a turn around the scene in so many images")
            ->type_name("N")
            ->check(aboveZero());
    CLI::Option* out = command->add_option("--out", arguments->out, "names of those images, as in frames/####.png");
    frames->needs(out);
    out->needs(frames);
    command->footer("H in the window lists its keys.\n\nExample:\n  eikonal view volumes/glass_sphere.toml");
    command->callback([arguments, &options] {
        if (arguments->frames > 0) {
            runTurntable(*arguments, options);
        } else {
            runWindow(*arguments);
        }
    });
}

} // namespace eikonal

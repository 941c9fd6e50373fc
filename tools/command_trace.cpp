#include "tools/command_trace.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"
#include "common/output_file.h"
#include "tools/ray_csv.h"
#include "tools/scene_arguments.h"
#include "tools/terminal.h"
#include "tools/usage.h"
#include "viewer/trace.h"

namespace eikonal {

namespace {

struct TraceArguments {
    SceneArguments scene;
    std::string rays;
    std::string output;
    bool points = false;
};

std::vector<TraceRay> traceRaysOf(const std::vector<RayRow>& rows) {
    std::vector<TraceRay> rays;
    rays.reserve(rows.size());
    for (const RayRow& row : rows) {
        TraceRay ray{.origin = row.origin, .direction = row.direction};
        if (row.wavelengthNm) {
            ray.wavelengthMicrons = 1e-3 * *row.wavelengthNm;
        }
        rays.push_back(ray);
    }
    return rays;
}

void runTrace(const TraceArguments& arguments, const ProgramOptions& options) {
    requireApart("--output", arguments.output, {arguments.scene.file, arguments.rays});
    requireWritable(arguments.output);
    const Scene scene = sceneOf(arguments.scene);
    const std::vector<TraceRay> rays = traceRaysOf(readRayCsv(arguments.rays));
    const gpu::Context context = gpu::Context::windowless();
    const Fields fields = composeImageFields(scene);
    Progress progress(options);
    warnOf(fields.warnings, progress);
    const EffectSet effects = decideEffects(scene, fields);
    const std::string text = arguments.points
                                 ? pointsCsv(tracePaths(context, fields, effects, scene.accuracy, rays))
                                 : resultsCsv(traceRays(context, fields, effects, scene.accuracy, rays));
    writeFile(arguments.output, text);
    note(options, fmt::format("{}: {} rays", arguments.output, rays.size()));
}

} // namespace

void addTraceCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("trace", "follow single rays through a scene's index field");
    auto arguments = std::make_shared<TraceArguments>();
    addSceneArguments(*command, arguments->scene);
    command->add_option("--rays", arguments->rays, "CSV with a header of x,y,z,dx,dy,dz [scene units] and, optionally, wavelength_nm")
        ->required()
        ->type_name("IN.csv");
    command->add_option("-o,--output", arguments->output, "CSV to write, a row per ray in order")
        ->required()
        ->type_name("OUT.csv");
    command->add_flag("--points", arguments->points, "write every step instead, with a column `ray`");
    command->footer("Example:\n  eikonal trace volumes/luneburg.toml --rays rays.csv -o ends.csv --set accuracy.step=0.5");
    command->callback([arguments, &options] { runTrace(*arguments, options); });
}

} // namespace eikonal

#include "tools/command_bake.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"
#include "common/output_file.h"
#include "lightsim/bake.h"
#include "lightsim/front.h"
#include "tools/bake_file.h"
#include "tools/front_ply.h"
#include "tools/scene_arguments.h"
#include "tools/statistics_json.h"
#include "tools/terminal.h"

namespace eikonal {

namespace {

struct BakeArguments {
    SceneArguments scene;
    std::string output;
    std::string statistics;
    std::vector<double> wavefront;  ///< optical times [scene units]; empty: a bake
};

void requireFrontArguments(const BakeArguments& arguments) {
    for (const double time : arguments.wavefront) {
        if (!(time > 0.0 && std::isfinite(time))) {
            throw CLI::ValidationError("--wavefront", fmt::format("expected optical times above 0, found {}", time));
        }
    }
    if (std::filesystem::path(arguments.output).extension() != ".ply") {
        throw CLI::ValidationError("--output", fmt::format("expected a name that ends in .ply with --wavefront, found '{}'",
                                                           arguments.output));
    }
}

double worstBalance(const EnergyLedger& energy) {
    const glm::dvec3 balance = glm::abs(energy.balance());
    return std::max({balance.r, balance.g, balance.b});
}

void runFronts(const BakeArguments& arguments, const ProgramOptions& options) {
    requireFrontArguments(arguments);
    requireWritable(arguments.output);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    progress.update("composing fields", 0.0);
    const Fields fields = composeFields(scene);
    BakeOptions bakeOptions;
    bakeOptions.progress = [&progress](double fraction) { progress.update("simulating light", fraction); };
    const auto patches =
        frontsAt(context, scene, fields, decideEffects(scene, fields), arguments.wavefront, bakeOptions);
    progress.finish();
    writeFrontPly(arguments.output, patches);
    note(options, fmt::format("{}: {} patches of wavefronts", arguments.output, patches.size()));
}

void runBake(const BakeArguments& arguments, const ProgramOptions& options) {
    requireWritable(arguments.output);
    if (!arguments.statistics.empty()) {
        requireWritable(arguments.statistics);
    }
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    progress.update("composing fields", 0.0);
    const Fields fields = composeFields(scene);
    const EffectSet effects = decideEffects(scene, fields);
    BakeOptions bakeOptions;
    bakeOptions.progress = [&progress](double fraction) { progress.update("simulating light", fraction); };
    const BakeResult result = bakeScene(context, scene, fields, effects, bakeOptions);
    progress.finish();

    writeBakeFile(arguments.output, scene, fields, result);
    if (!arguments.statistics.empty()) {
        writeFile(arguments.statistics, bakeJson(result.statistics, effects).dump(2) + "\n");
    }
    note(options, fmt::format("{}: {} x {} x {} voxels in {:.2f} s, energy balance within {:.1e}", arguments.output,
                              fields.lattice.size.x, fields.lattice.size.y, fields.lattice.size.z,
                              result.statistics.seconds.total, worstBalance(result.statistics.energy)));
}

} // namespace

void addBakeCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("bake", "simulate a scene's light; write irradiance as a VDB");
    auto arguments = std::make_shared<BakeArguments>();
    addSceneArguments(*command, arguments->scene);
    command->add_option("-o,--output", arguments->output, "VDB to write; with --wavefront a PLY")
        ->required()
        ->type_name("BAKE.vdb");
    CLI::Option* statistics =
        command->add_option("--stats", arguments->statistics, "write seconds, patch counts and the energy ledger as JSON")
            ->type_name("FILE.json");
    command->add_option("--wavefront", arguments->wavefront,
                        "write the wavefronts' patches at these optical times instead of a bake; in scene units from when "
                        "a light first meets the domain")
        ->type_name("T1,T2,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(statistics);
    addIntegerKey(*command, arguments->scene,
                  {"--resolution", "domain.resolution", "VOXELS",
                   fmt::format("voxels along the domain's longest side [the scene's, else {}]", Domain{}.resolution)});
    addNumberKey(*command, arguments->scene,
                 {"--tolerance", "accuracy.tolerance", "FRACTION",
                  fmt::format("target relative error of irradiance [the scene's, else {}]", Accuracy{}.tolerance)});
    command->footer("Example:\n  eikonal bake volumes/glass_sphere.toml -o bake.vdb --resolution 96 --stats bake.json\n"
                    "  eikonal bake volumes/glass_sphere.toml -o front.ply --wavefront 0.5,1.5,2.5");
    command->callback([arguments, &options] {
        arguments->wavefront.empty() ? runBake(*arguments, options) : runFronts(*arguments, options);
    });
}

} // namespace eikonal

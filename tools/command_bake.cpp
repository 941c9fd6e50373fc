#include "tools/command_bake.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"
#include "common/output_file.h"
#include "common/vdb_limits.h"
#include "lightsim/front.h"
#include "lightsim/per_light.h"
#include "tools/bake_file.h"
#include "tools/effect_table.h"
#include "tools/frame_name.h"
#include "tools/front_ply.h"
#include "tools/scene_arguments.h"
#include "tools/second_look.h"
#include "tools/stage_clock.h"
#include "tools/statistics_json.h"
#include "tools/terminal.h"
#include "tools/usage.h"

namespace eikonal {

namespace {

struct BakeArguments {
    SceneArguments scene;
    std::string output;
    std::string statistics;
    std::vector<double> wavefront;  ///< optical times [scene units]; empty: a bake
    int frames = 0;  ///< of a sequence; 0: a single bake, of frame 0
    bool perLight = false;
    bool eikonal = false;
    bool noEstimate = false;

    bool isSequence() const { return frames > 0; }
    std::string outputOf(int frame) const { return isSequence() ? frameName(output, frame) : output; }
};

void requireFrontArguments(const BakeArguments& arguments) {
    for (const double time : arguments.wavefront) {
        if (!(time > 0.0 && std::isfinite(time))) {
            throw CLI::ValidationError("--wavefront", fmt::format("expected optical times above 0, found {}", time));
        }
    }
    requireExtension("--output with --wavefront", arguments.output, ".ply");
}

double worstBalance(const EnergyLedger& energy) {
    const glm::dvec3 balance = glm::abs(energy.balance());
    return std::max({balance.r, balance.g, balance.b});
}

double worstBalance(const BakeStatistics& statistics) {
    if (statistics.bands.empty()) {
        return worstBalance(statistics.energy);
    }
    double worst = 0.0;
    for (const BandLedger& band : statistics.bands) {
        worst = std::max(worst, worstBalance(band.energy));
    }
    return worst;
}

void runFronts(const BakeArguments& arguments, const ProgramOptions& options) {
    requireFrontArguments(arguments);
    requireWritable(arguments.output);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    progress.update("composing fields", 0.0);
    const Fields fields = composeFields(scene);
    warnOf(fields.warnings, progress);
    warnOfLight(scene, progress);
    const EffectSet effects = decideEffects(scene, fields);
    explainEffects(arguments.scene, effects, fields, progress);
    BakeOptions bakeOptions;
    bakeOptions.progress = [&progress](double fraction) { progress.update("simulating light", fraction); };
    const auto patches = frontsAt(context, scene, fields, effects, arguments.wavefront, bakeOptions);
    progress.finish();
    writeFrontPly(arguments.output, patches);
    note(options, fmt::format("{}: {} patches of wavefronts", arguments.output, patches.size()));
}

/// A single bake's statistics as they are, those of a sequence as a list.
nlohmann::json statisticsJson(const BakeArguments& arguments, const std::vector<nlohmann::json>& rows) {
    return arguments.isSequence() ? nlohmann::json{{"frames", rows}} : rows.front();
}

void requireOutputs(const BakeArguments& arguments) {
    if (arguments.isSequence() && !hasFrameNumber(arguments.output)) {
        throw CLI::ValidationError("--output", fmt::format("expected a name with #### in place of the frame's number, "
                                                           "found '{}'", arguments.output));
    }
    requireExtension("--output", arguments.output, ".vdb");
    requireApart("--output", arguments.outputOf(0), {arguments.scene.file, arguments.statistics});
    requireWritable(arguments.outputOf(0));
    if (!arguments.statistics.empty()) {
        requireApart("--stats", arguments.statistics, {arguments.scene.file});
        requireWritable(arguments.statistics);
    }
}

void noteBake(const std::string& file, const BakeResult& result, const ProgramOptions& options) {
    const glm::ivec3& size = result.light.lattice.size;
    note(options, fmt::format("{}: {} x {} x {} voxels in {:.2f} s, energy balance within {:.1e}", file, size.x, size.y,
                              size.z, result.statistics.seconds.total, worstBalance(result.statistics)));
    if (result.statistics.energy.entered == glm::dvec3(0.0)) {
        warn(fmt::format("{}: no light enters the domain", file));
    }
}

/// The files of bakes, each written on a thread of its own while the next bake is made. Two bakes are in memory then.
class BakeFiles {
public:
    BakeFiles(const BakeArguments& arguments, const ProgramOptions& options, const Scene& scene, const Fields& fields)
        : arguments_(arguments), options_(options), scene_(scene), fields_(fields) {}

    /// Begins to write a bake, after finish(). Throws as that does.
    void write(int frame, std::shared_ptr<const BakeResult> result) {
        finish();
        begun_ = {frame, std::move(result)};
        written_ = std::async(std::launch::async, [this] {
            writeBakeFile(arguments_.outputOf(begun_.frame), scene_, fields_, *begun_.result,
                          arguments_.isSequence() ? std::optional(begun_.frame) : std::nullopt);
        });
    }

    /// Waits for the file that was begun and says that it is there. Throws what writing it threw.
    void finish() {
        if (written_.valid()) {
            written_.get();
            noteBake(arguments_.outputOf(begun_.frame), *begun_.result, options_);
        }
    }

private:
    struct Begun {
        int frame = 0;
        std::shared_ptr<const BakeResult> result;
    };

    const BakeArguments& arguments_;
    const ProgramOptions& options_;
    const Scene& scene_;
    const Fields& fields_;
    Begun begun_;
    std::future<void> written_;  ///< last, for what it uses must outlive it
};

void runBake(const BakeArguments& arguments, const ProgramOptions& options) {
    StageClock clock;
    requireOutputs(arguments);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    progress.update("composing fields", 0.0);
    const Fields fields = composeFields(scene);
    warnOf(fields.warnings, progress);
    warnOfLight(scene, progress);
    requireVdbHolds(arguments.output, fields.lattice);
    const EffectSet effects = decideEffects(scene, fields);
    explainEffects(arguments.scene, effects, fields, progress);
    const LightSet lights = lightsOf(scene, effects);
    BakeOptions bakeOptions;
    bakeOptions.eikonal = arguments.eikonal;
    bakeOptions.progress = [&progress](double fraction) { progress.update("simulating light", fraction); };
    LightSimulator simulator(context, scene, fields, effects, bakeOptions);
    clock.lap("compose");
    std::optional<SecondLook> secondLook;
    if (!arguments.statistics.empty() && !arguments.noEstimate) {
        secondLook.emplace(context, scene, fields, effects);
        clock.lap("estimate");
    }
    BakeFiles files(arguments, options, scene, fields);
    std::vector<nlohmann::json> statistics;
    const int frames = std::max(arguments.frames, 1);
    for (int frame = 0; frame < frames; ++frame) {
        const LightSet placed = lightsAt(lights, frame);
        const auto result = std::make_shared<const BakeResult>(arguments.perLight ? bakePerLight(simulator, placed)
                                                                                  : simulator.bake(placed));
        progress.finish();
        clock.lap("other", stagesOf(result->statistics.seconds));
        files.write(frame, result);
        clock.lap("write");
        statistics.push_back(bakeJson(result->statistics, effects));
        if (secondLook) {
            statistics.back()["error_estimate"] = secondLook->estimateJson(placed, result->light);
            clock.lap("estimate");
        }
        if (frame + 1 == frames) {
            files.finish();
            clock.lap("write");
        }
        statistics.back()["seconds"] = clock.take();
    }
    if (!arguments.statistics.empty()) {
        writeFile(arguments.statistics, statisticsJson(arguments, statistics).dump(2) + "\n");
    }
}

} // namespace

void addBakeCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("bake", "simulate a scene's light; write irradiance as a VDB");
    auto arguments = std::make_shared<BakeArguments>();
    addSceneArguments(*command, arguments->scene);
    addExplainFlag(*command, arguments->scene);
    command->add_option("-o,--output", arguments->output, "VDB to write; with --wavefront a PLY")
        ->required()
        ->type_name("BAKE.vdb");
    CLI::Option* statistics =
        command->add_option("--stats", arguments->statistics, "write seconds, patch counts, the energy ledger and an estimate of the error as JSON")
            ->type_name("FILE.json");
    command->add_flag("--no-estimate", arguments->noEstimate,
                      "with --stats: spare the second look at the light that the estimate takes");
    CLI::Option* frames =
        command->add_option("--frames", arguments->frames,
                            "bake frames 0 to N-1 of lights that move; #### in the output's name becomes the frame's number")
            ->type_name("N")
            ->check(aboveZero());
    CLI::Option* perLight =
        command->add_flag("--per-light", arguments->perLight, "simulate each light on its own and write its grids too");
    CLI::Option* eikonal =
        command->add_flag("--eikonal", arguments->eikonal,
                          "write the least optical path from a light to each voxel too, as grid 'eikonal'");
    command->add_option("--wavefront", arguments->wavefront,
                        "write the wavefronts' patches at these optical times instead of a bake; in scene units from when "
                        "a light first meets the domain")
        ->type_name("T1,T2,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(statistics)
        ->excludes(frames)
        ->excludes(perLight)
        ->excludes(eikonal);
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

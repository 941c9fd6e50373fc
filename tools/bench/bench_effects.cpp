#include "tools/bench/bench_effects.h"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/gpu/context.h"
#include "common/interrupt.h"
#include "common/stage_fields.h"
#include "lightsim/bake.h"
#include "tools/bench/bar_chart.h"
#include "tools/bench/effect_ladder.h"
#include "tools/bench/table_files.h"
#include "tools/scene_arguments.h"
#include "tools/terminal.h"

namespace eikonal {

namespace {

struct LadderArguments {
    SceneArguments scene;
    bench::TableFiles files;
    int repeats = 3;
};

std::string ladderSvg(const std::vector<bench::Rung>& rungs, const std::string& scene) {
    std::vector<bench::Bar> bars;
    for (const bench::Rung& rung : rungs) {
        const std::string label = bars.empty() ? rung.added : "+ " + rung.added;
        bars.push_back({label, rung.seconds,
                        fmt::format("{:.2f} s, {:.1f} M fetches", rung.seconds, 1e-6 * double(rung.fetches))});
    }
    return bench::barChartSvg("Seconds of an image, effect by effect: " + scene, bars);
}

void runLadder(const LadderArguments& arguments, const ProgramOptions& options) {
    bench::requireWritable(arguments.files);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    const StageFields stages = composeStageFields(scene);
    const EffectSet& effects = stages.image.effects;
    const auto report = [&](const char* stage) {
        return [&progress, stage](double fraction) {
            throwIfInterrupted();
            progress.update(stage, fraction);
        };
    };
    std::optional<BakedLight> light;
    if (effects.wantsLight(scene)) {
        BakeOptions bakeOptions;
        bakeOptions.progress = report("simulating light");
        light = bakeScene(context, scene, *stages.light.fields, stages.light.effects, bakeOptions).light;
    }
    const auto rungs = bench::climbLadder(context, scene, *stages.image.fields, effects, light ? &*light : nullptr, arguments.repeats,
                                          report("rendering"));
    progress.finish();
    bench::write(arguments.files, bench::ladderCsv(rungs), ladderSvg(rungs, arguments.scene.file));
}

} // namespace

void addBenchEffects(CLI::App& bench, const ProgramOptions& options) {
    CLI::App* command = bench.add_subcommand("effects", "what each effect adds to the cost of an image");
    auto arguments = std::make_shared<LadderArguments>();
    addSceneArguments(*command, arguments->scene);
    bench::addTableFiles(*command, arguments->files, "bars of the seconds");
    addSizeKey(*command, arguments->scene, {"--size", "render.size", "WxH", "pixels [the scene's]"});
    command->add_option("--repeats", arguments->repeats, "images of each; the shortest time counts")
        ->capture_default_str()
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command->footer("Example:\n  eikonal bench effects volumes/glass_sphere.toml -o ladder.csv --svg ladder.svg");
    command->callback([arguments, &options] { runLadder(*arguments, options); });
}

} // namespace eikonal

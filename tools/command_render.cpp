#include "tools/command_render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "common/file_kind.h"
#include "common/gpu/context.h"
#include "common/interrupt.h"
#include "common/output_file.h"
#include "common/stage_fields.h"
#include "lightsim/bake.h"
#include "tools/bake_file.h"
#include "tools/effect_table.h"
#include "tools/scene_arguments.h"
#include "tools/second_look.h"
#include "tools/stage_clock.h"
#include "tools/statistics_json.h"
#include "tools/terminal.h"
#include "tools/usage.h"
#include "viewer/image_file.h"
#include "viewer/render.h"

namespace eikonal {

namespace {

struct RenderArguments {
    SceneArguments scene;
    std::string output;
    std::string bake;
    std::string statistics;
    bool force = false;
    bool noEstimate = false;
};

constexpr std::array<std::string_view, 4> kExtensions{".exr", ".png", ".jpg", ".jpeg"};

/// Empty if the name of an image ends as one that can be written, else what is wrong: a check of CLI11.
std::string checkImageName(const std::string& file) {
    const std::string extension = extensionOf(file);
    const bool known = std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
    return known ? std::string() : fmt::format("expected a name that ends in .exr, .png or .jpg, found '{}'", file);
}

void requireOutputs(const RenderArguments& arguments) {
    requireApart("--output", arguments.output, {arguments.scene.file, arguments.bake, arguments.statistics});
    requireWritable(arguments.output);
    if (!arguments.statistics.empty()) {
        requireApart("--stats", arguments.statistics, {arguments.scene.file, arguments.bake});
        requireWritable(arguments.statistics);
    }
}

/// The scene's light: from a file, simulated now, or none where nothing would show it.
struct Light {
    std::optional<BakedLight> baked;
    std::optional<BakeStatistics> statistics;  ///< where it was simulated now
};

Light lightOf(const RenderArguments& arguments, const gpu::Context& context, const Scene& scene, const StageFields& stages,
              Progress& progress) {
    const Fields& fields = *stages.light.fields;
    if (!arguments.bake.empty()) {
        const OtherScene otherScene = arguments.force ? OtherScene::kAccept : OtherScene::kRefuse;
        return {readBakeFile(arguments.bake, scene, fields, otherScene), std::nullopt};
    }
    if (!stages.image.effects.wantsLight(scene)) {
        return {};
    }
    warnOfLight(scene, progress);
    BakeOptions options;
    options.progress = [&progress](double fraction) { progress.update("simulating light", fraction); };
    BakeResult result = bakeScene(context, scene, fields, stages.light.effects, options);
    return {std::move(result.light), std::move(result.statistics)};
}

/// The scene with the samples that its image took: a target of noise may have ended them early.
Scene asTaken(Scene scene, const RenderResult& image) {
    scene.render.samples = int(std::lround(image.statistics.samples));
    return scene;
}

nlohmann::json statisticsOf(const RenderResult& image, const Light& light, const StageFields& stages) {
    nlohmann::json statistics = renderJson(image.statistics, stages.image.effects);
    if (light.statistics) {
        statistics["bake"] = bakeJson(*light.statistics, stages.light.effects);
    }
    return statistics;
}

/// What the image and its light, if that was simulated now, are off by.
void addEstimates(nlohmann::json& statistics, const gpu::Context& context, const Scene& taken, const StageFields& stages,
                  const Light& light, const RenderOptions& options) {
    const BakedLight* baked = light.baked ? &*light.baked : nullptr;
    const auto& image = stages.image;
    statistics["error_estimate"] = errorJson(estimateError(context, taken, *image.fields, image.effects, baked, options));
    if (light.statistics) {
        const auto& bake = stages.light;
        SecondLook secondLook(context, taken, *bake.fields, bake.effects);
        statistics["bake"]["error_estimate"] = secondLook.estimateJson(lightsAt(lightsOf(taken, bake.effects), 0.0), *light.baked);
    }
}

void runRender(const RenderArguments& arguments, const ProgramOptions& options) {
    StageClock clock;
    requireOutputs(arguments);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    Progress progress(options);
    progress.update("composing fields", 0.0);
    const StageFields stages = composeStageFields(scene);
    warnOf(stages.light.fields->warnings, progress);
    const Fields& fields = *stages.image.fields;
    const EffectSet& effects = stages.image.effects;
    explainEffects(arguments.scene, effects, fields, progress);
    clock.lap("compose");
    const Light light = lightOf(arguments, context, scene, stages, progress);
    clock.lap("light");
    RenderOptions renderOptions;
    renderOptions.channels = hasChannels(arguments.output);
    renderOptions.progress = [&progress](double fraction) {
        throwIfInterrupted();
        progress.update("rendering", fraction);
    };
    const BakedLight* baked = light.baked ? &*light.baked : nullptr;
    const RenderResult image = renderScene(context, scene, fields, effects, baked, renderOptions);
    clock.lap("image", {image.statistics.seconds.front()});
    nlohmann::json statistics = statisticsOf(image, light, stages);
    if (!arguments.statistics.empty() && !arguments.noEstimate) {
        addEstimates(statistics, context, asTaken(scene, image), stages, light, renderOptions);
        clock.lap("estimate");
    }
    progress.finish();

    writeRendered(arguments.output, image,
                  attributesOf(image, scene, fmt::format("{} {}", kCreator, kVersion)));
    clock.lap("write");
    if (!arguments.statistics.empty()) {
        statistics["seconds"] = clock.take();
        writeFile(arguments.statistics, statistics.dump(2) + "\n");
    }
    note(options, fmt::format("{}: {} x {} pixels, {:.0f} samples each, in {:.2f} s", arguments.output, image.size.x,
                              image.size.y, image.statistics.samples, image.statistics.seconds.back().second));
}

void addRenderOptions(CLI::App& command, RenderArguments& arguments) {
    const RenderSettings defaults;
    addSceneArguments(command, arguments.scene);
    addExplainFlag(command, arguments.scene);
    command
        .add_option("-o,--output", arguments.output,
                    "image to write: .exr is linear with further channels, .png and .jpg are tone-mapped")
        ->required()
        ->type_name("IMAGE")
        ->check(checkImageName);
    command.add_option("--bake", arguments.bake, "light from `eikonal bake` [simulated where the scene shows light]")
        ->type_name("BAKE.vdb");
    command.add_flag("--force", arguments.force, "use the bake even if it was made for another scene");
    addSizeKey(command, arguments.scene,
               {"--size", "render.size", "WxH",
                fmt::format("pixels [the scene's, else {}x{}]", defaults.size.x, defaults.size.y)});
    addIntegerKey(command, arguments.scene,
                  {"--samples", "render.samples", "N",
                   fmt::format("samples per pixel, at most where the scene asks for a noise [the scene's, else {}]",
                               defaults.samples)});
    addNumberKey(command, arguments.scene,
                 {"--noise", "render.noise", "SHARE",
                  fmt::format("relative standard error at which sampling ends [the scene's, else {}: never]", defaults.noise)});
    command
        .add_option("--stats", arguments.statistics, "write seconds, rays, steps, noise and an estimate of the error as JSON")
        ->type_name("FILE.json");
    command.add_flag("--no-estimate", arguments.noEstimate, "with --stats: spare what the estimates of the errors take");
}

} // namespace

void addRenderCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("render", "one image of a scene, along curved rays");
    auto arguments = std::make_shared<RenderArguments>();
    addRenderOptions(*command, *arguments);
    command->footer("Example:\n  eikonal render volumes/glass_sphere.toml -o sphere.png --size 640x480 --samples 4");
    command->callback([arguments, &options] { runRender(*arguments, options); });
}

} // namespace eikonal

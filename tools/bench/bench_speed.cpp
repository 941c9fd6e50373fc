#include "tools/bench/bench_speed.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/fields.h"
#include "common/gpu/context.h"
#include "tools/bench/bar_chart.h"
#include "tools/bench/march_rates.h"
#include "tools/bench/table_files.h"
#include "tools/scene_arguments.h"

namespace eikonal {

namespace {

struct SpeedArguments {
    SceneArguments scene;
    bench::TableFiles files;
    int repeats = 5;
};

std::string ratesCsv(const bench::MarchRates& rates, const std::string& device) {
    const auto row = [&](const char* name, const bench::Rate& rate) {
        return fmt::format("{},{:.0f},{:.6f},{:.2f},{:.3f}\n", name, rate.count, rate.seconds, 1e-6 * rate.perSecond(),
                           rate.perSecond() / rates.fetches.perSecond());
    };
    return fmt::format("# {}; {:.0f} rays\nkernel,fetches,seconds,million_per_second,share\n", device, rates.rays) +
           row("dependent_fetches", rates.fetches) + row("march_steps", rates.stepping) + row("march_flights", rates.flying) +
           row("image", rates.image);
}

std::string ratesSvg(const bench::MarchRates& rates, const std::string& scene) {
    const auto bar = [&](const char* label, const bench::Rate& rate) {
        return bench::Bar{label, rate.perSecond(),
                          fmt::format("{:.0f} M/s, {:.1f} M in {:.3f} s", 1e-6 * rate.perSecond(), 1e-6 * rate.count, rate.seconds)};
    };
    return bench::barChartSvg("Fetches of the index a second: " + scene,
                              {bar("fetches alone", rates.fetches), bar("every step", rates.stepping),
                               bar("with flights", rates.flying), bar("whole image", rates.image)});
}

void runSpeed(const SpeedArguments& arguments, const ProgramOptions& options) {
    bench::requireWritable(arguments.files);
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    const Fields fields = composeImageFields(scene);
    const bench::MarchRates rates = bench::measureMarchRates(context, scene, fields, arguments.repeats);
    bench::write(arguments.files, ratesCsv(rates, context.rendererName()), ratesSvg(rates, arguments.scene.file));
    note(options, fmt::format("marching has {:.0f} % of the rate of dependent fetches; flights need {:.1f} times fewer; an "
                              "image takes {:.2f} times as long as its marching",
                              100.0 * rates.stepping.perSecond() / rates.fetches.perSecond(),
                              rates.stepping.count / rates.flying.count, rates.image.seconds / rates.flying.seconds));
}

} // namespace

void addBenchSpeed(CLI::App& bench, const ProgramOptions& options) {
    CLI::App* command =
        bench.add_subcommand("speed", "marching with refraction only against the machine's own limit");
    auto arguments = std::make_shared<SpeedArguments>();
    addSceneArguments(*command, arguments->scene);
    bench::addTableFiles(*command, arguments->files, "bars of the rates");
    addSizeKey(*command, arguments->scene, {"--size", "render.size", "WxH", "rays, one a pixel [the scene's]"});
    command->add_option("--repeats", arguments->repeats, "times that each is measured; the shortest counts")
        ->capture_default_str()
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command->footer("Example:\n  eikonal bench speed volumes/glass_sphere.toml -o speed.csv --svg speed.svg");
    command->callback([arguments, &options] { runSpeed(*arguments, options); });
}

} // namespace eikonal

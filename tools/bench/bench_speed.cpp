#include "tools/bench/bench_speed.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/fields.h"
#include "common/gpu/context.h"
#include "tools/bench/march_rates.h"
#include "tools/scene_arguments.h"

namespace eikonal {

namespace {

struct SpeedArguments {
    SceneArguments scene;
    int repeats = 5;
};

void printRates(const bench::MarchRates& rates, const std::string& device) {
    const auto print = [&](const char* name, const bench::Rate& rate) {
        fmt::print("{},{:.0f},{:.6f},{:.2f},{:.3f}\n", name, rate.count, rate.seconds, 1e-6 * rate.perSecond(),
                   rate.perSecond() / rates.fetches.perSecond());
    };
    fmt::print("# {}; {:.0f} rays\n", device, rates.rays);
    fmt::print("kernel,fetches,seconds,million_per_second,share\n");
    print("dependent_fetches", rates.fetches);
    print("march_steps", rates.stepping);
    print("march_flights", rates.flying);
}

void runSpeed(const SpeedArguments& arguments, const ProgramOptions& options) {
    const Scene scene = sceneOf(arguments.scene);
    const gpu::Context context = gpu::Context::windowless();
    const Fields fields = composeImageFields(scene);
    const bench::MarchRates rates = bench::measureMarchRates(context, scene, fields, arguments.repeats);
    printRates(rates, context.rendererName());
    note(options, fmt::format("marching has {:.0f} % of the rate of dependent fetches; flights need {:.1f} times fewer",
                              100.0 * rates.stepping.perSecond() / rates.fetches.perSecond(),
                              rates.stepping.count / rates.flying.count));
}

} // namespace

void addBenchSpeed(CLI::App& bench, const ProgramOptions& options) {
    CLI::App* command =
        bench.add_subcommand("speed", "marching with refraction only against the machine's own limit, as CSV");
    auto arguments = std::make_shared<SpeedArguments>();
    addSceneArguments(*command, arguments->scene);
    addSizeKey(*command, arguments->scene, {"--size", "render.size", "WxH", "rays, one a pixel [the scene's]"});
    command->add_option("--repeats", arguments->repeats, "times that each is measured; the shortest counts")
        ->capture_default_str()
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command->footer("Example:\n  eikonal bench speed volumes/glass_sphere.toml --set domain.resolution=128");
    command->callback([arguments, &options] { runSpeed(*arguments, options); });
}

} // namespace eikonal

#include "tools/bench/bench_accuracy.h"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/error.h"
#include "common/output_file.h"
#include "tools/bench/image_bench.h"
#include "tools/bench/irradiance_bench.h"
#include "tools/bench/ray_bench.h"

namespace eikonal {

namespace {

struct AccuracyArguments {
    std::string folder;
    std::string family = "all";
    bool quick = false;

    bool wants(std::string_view name) const { return family == "all" || family == name; }
};

bench::RayBenchOptions rayOptions(bool quick) {
    return quick ? bench::RayBenchOptions{.rays = 24, .resolutions = {64, 128}, .steps = 8} : bench::RayBenchOptions{};
}

bench::IrradianceBenchOptions irradianceOptions(bool quick) {
    return quick ? bench::IrradianceBenchOptions{.resolutions = {24}, .tolerances = {0.8, 0.4, 0.08, 0.02}}
                 : bench::IrradianceBenchOptions{};
}

bench::ImageBenchOptions imageOptions(bool quick) {
    return quick ? bench::ImageBenchOptions{.pixels = 24,
                                            .resolution = 32,
                                            .stepsVoxels = {4.0, 2.0, 1.0, 0.5, 0.25},
                                            .samples = {1, 4, 16},
                                            .tolerances = {0.08, 0.02}}
                 : bench::ImageBenchOptions{};
}

void createFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw failure(fmt::format("{}: expected a folder or a place for one; {}", folder.string(), error.message()));
    }
}

void writeFamily(const std::filesystem::path& folder, const bench::Family& family, const ProgramOptions& options) {
    writeFile(folder / (family.name + ".csv"), bench::csvOf(family));
    writeFile(folder / (family.name + ".svg"), bench::diagramOf(family, bench::Work::kEvaluations));
    writeFile(folder / (family.name + "_seconds.svg"), bench::diagramOf(family, bench::Work::kSeconds));
    note(options, fmt::format("{}: {} measurements", (folder / family.name).string() + ".csv", family.rows.size()));
}

void runAccuracy(const AccuracyArguments& arguments, const ProgramOptions& options) {
    const std::filesystem::path folder(arguments.folder);
    createFolder(folder);
    requireWritable(folder / "accuracy.md");
    std::string summary = "# What accuracy costs\n\n";
    const auto add = [&](const bench::Family& family) {
        writeFamily(folder, family, options);
        summary += bench::summaryOf(family);
    };
    if (arguments.wants("rays")) {
        add(bench::benchRays(rayOptions(arguments.quick)));
    }
    if (arguments.wants("irradiance")) {
        add(bench::benchIrradiance(gpu::Context::windowless(), irradianceOptions(arguments.quick)));
    }
    if (arguments.wants("image")) {
        add(bench::benchImage(gpu::Context::windowless(), imageOptions(arguments.quick)));
    }
    writeFile(folder / "accuracy.md", summary);
}

} // namespace

void addBenchAccuracy(CLI::App& bench, const ProgramOptions& options) {
    CLI::App* command = bench.add_subcommand("accuracy", "error against closed forms over field evaluations and time");
    auto arguments = std::make_shared<AccuracyArguments>();
    command->add_option("-o,--output", arguments->folder, "folder for tables, diagrams and a summary, accuracy.md")
        ->required()
        ->type_name("FOLDER");
    command->add_option("--family", arguments->family, "what is measured")
        ->check(CLI::IsMember({"all", "rays", "irradiance", "image"}))
        ->capture_default_str();
    command->add_flag("--quick", arguments->quick, "few rays and coarse voxels: under a minute on two cores");
    command->footer("Example:\n  eikonal bench accuracy --quick -o accuracy");
    command->callback([arguments, &options] { runAccuracy(*arguments, options); });
}

} // namespace eikonal

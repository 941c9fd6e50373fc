#include "tools/command_figure.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/mesh_generate.h"
#include "common/output_file.h"

namespace eikonal {

namespace {

struct FigureArguments {
    KnotOptions knot;
    std::string output;
};

void runFigure(const FigureArguments& arguments, const ProgramOptions& options) {
    requireWritable(arguments.output);
    const Mesh mesh = generateKnot(arguments.knot);
    writeObj(arguments.output, mesh);
    note(options, fmt::format("{}: {} triangles, volume {:.4f}", arguments.output, mesh.triangles.size(), meshVolume(mesh)));
}

} // namespace

void addFigureCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("figure", "write a trefoil knot as a mesh: the figure of the demonstration");
    auto arguments = std::make_shared<FigureArguments>();
    KnotOptions& knot = arguments->knot;
    command->add_option("-o,--output", arguments->output, "mesh to write")->required()->type_name("OUT.obj");
    command->add_option("--segments", knot.segments, "quads along the knot")->check(CLI::Range(12, 10000))->capture_default_str();
    command->add_option("--tube", knot.tube, "larger half axis of the cross-section, in half major radii")
        ->check(CLI::Range(0.05, 0.8))
        ->capture_default_str();
    command->add_option("--flattening", knot.flattening, "ratio of the cross-section's half axes")
        ->check(CLI::Range(0.1, 1.0))
        ->capture_default_str();
    command->add_option("--twists", knot.twists, "half turns of the cross-section along the knot")
        ->check(CLI::Range(0, 12))
        ->capture_default_str();
    command->footer("Example:\n  eikonal figure -o trefoil.obj && eikonal voxelize trefoil.obj -o trefoil.vdb");
    command->callback([arguments, &options] { runFigure(*arguments, options); });
}

} // namespace eikonal

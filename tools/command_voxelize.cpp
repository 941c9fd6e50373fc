#include "tools/command_voxelize.h"

#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "common/output_file.h"
#include "common/voxelize.h"
#include "tools/usage.h"

namespace eikonal {

namespace {

struct VoxelizeArguments {
    VoxelizeOptions voxels;
    std::string mesh;
    std::string output;
    std::vector<double> absorption;
};

void reportMesh(const std::string& file, const MeshReport& report, const ProgramOptions& options) {
    note(options, fmt::format("{}: {} triangles, {} vertices, {}", file, report.triangles, report.vertices,
                              report.openEdges == 0 ? "closed" : fmt::format("{} open edges", report.openEdges)));
    for (const std::string& message : report.messages) {
        warn(fmt::format("{}: {}", file, message));
    }
}

void reportVoxels(const VoxelizeArguments& arguments, const VoxelizedMesh& result, const ProgramOptions& options) {
    for (const std::string& message : result.warnings) {
        warn(fmt::format("{}: {}", arguments.mesh, message));
    }
    const glm::ivec3& size = result.lattice.size;
    note(options, fmt::format("{}: {} x {} x {} voxels of {:.4g}, volume {:.5g} (the mesh's: {:.5g})", arguments.output, size.x,
                              size.y, size.z, result.lattice.voxel, result.voxelizedVolume, result.meshVolume));
}

void runVoxelize(VoxelizeArguments& arguments, const ProgramOptions& options) {
    if (!arguments.absorption.empty()) {
        arguments.voxels.absorption = {arguments.absorption[0], arguments.absorption[1], arguments.absorption[2]};
    }
    requireExtension("--output", arguments.output, ".vdb");
    requireWritable(arguments.output);
    const SolidMesh solid = loadSolidMesh(arguments.mesh);
    reportMesh(arguments.mesh, solid.report, options);
    const VoxelizedMesh result = voxelize(solid.mesh, arguments.voxels);
    writeVoxelized(arguments.output, result, arguments.voxels, arguments.mesh);
    reportVoxels(arguments, result, options);
}

} // namespace

void addVoxelizeCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("voxelize", "turn a closed triangle mesh into an index field (VDB)");
    auto arguments = std::make_shared<VoxelizeArguments>();
    VoxelizeOptions& voxels = arguments->voxels;
    command->add_option("MESH", arguments->mesh, "OBJ, PLY, STL or glTF")->required();
    command->add_option("-o,--output", arguments->output, "VDB to write")->required()->type_name("OUT.vdb");
    command->add_option("--ior", voxels.ior, "refractive index inside")->capture_default_str();
    CLI::Option* resolution =
        command->add_option("--resolution", voxels.resolution, "voxels along the grid's longest side, padding included")
            ->type_name("VOXELS")
            ->capture_default_str();
    command->add_option("--voxel", voxels.voxelSize, "edge of a voxel, in the mesh's unit")->type_name("SIZE")->excludes(resolution);
    command->add_option("--smooth", voxels.smoothVoxels, "width b of the boundary; 0: by area")
        ->type_name("VOXELS")
        ->capture_default_str();
    command->add_option("--absorption", arguments->absorption, "also write absorption, by band [1 / scene unit]")
        ->type_name("R,G,B")
        ->delimiter(',')
        ->expected(3);
    command->add_option("--padding", voxels.paddingVoxels, "empty voxels around the mesh [4 b + 1]")->type_name("VOXELS");
    command->footer("Example:\n  eikonal voxelize bunny.ply -o bunny.vdb --ior 1.5 --resolution 128 --absorption 0.1,0.8,2");
    command->callback([arguments, &options] { runVoxelize(*arguments, options); });
}

} // namespace eikonal

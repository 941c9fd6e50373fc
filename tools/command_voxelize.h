#pragma once
// `eikonal voxelize`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addVoxelizeCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

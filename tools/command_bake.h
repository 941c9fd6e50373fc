#pragma once
// `eikonal bake`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addBakeCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

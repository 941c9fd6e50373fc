#pragma once
// `eikonal bench`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addBenchCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

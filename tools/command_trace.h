#pragma once
// `eikonal trace`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addTraceCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

#pragma once
// `eikonal info`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addInfoCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

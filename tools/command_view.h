#pragma once
// `eikonal view SCENE`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addViewCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

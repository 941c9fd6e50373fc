#pragma once
// `eikonal render`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addRenderCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

#pragma once
// `eikonal bench speed`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addBenchSpeed(CLI::App& bench, const ProgramOptions& options);

} // namespace eikonal

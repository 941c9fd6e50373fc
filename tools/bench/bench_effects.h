#pragma once
// `eikonal bench effects`.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addBenchEffects(CLI::App& bench, const ProgramOptions& options);

} // namespace eikonal

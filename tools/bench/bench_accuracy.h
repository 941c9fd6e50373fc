#pragma once
// `eikonal bench accuracy`: error against closed forms over field evaluations and seconds.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addBenchAccuracy(CLI::App& bench, const ProgramOptions& options);

} // namespace eikonal

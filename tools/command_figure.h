#pragma once
// `eikonal figure`: the mesh of the demonstration, made by formula.

#include "tools/program.h"

namespace CLI {
class App;
}

namespace eikonal {

void addFigureCommand(CLI::App& program, const ProgramOptions& options);

} // namespace eikonal

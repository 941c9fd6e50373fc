#include "tools/command_bench.h"

#include <CLI/CLI.hpp>

#include "tools/bench/bench_accuracy.h"

namespace eikonal {

void addBenchCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("bench", "measurements of this program on this machine");
    command->require_subcommand(1);
    addBenchAccuracy(*command, options);
}

} // namespace eikonal

#include "tools/command_bench.h"

#include <CLI/CLI.hpp>

#include "tools/bench/bench_accuracy.h"
#include "tools/bench/bench_effects.h"
#include "tools/bench/bench_speed.h"

namespace eikonal {

void addBenchCommand(CLI::App& program, const ProgramOptions& options) {
    CLI::App* command = program.add_subcommand("bench", "measurements of this program on this machine");
    command->require_subcommand(1);
    addBenchAccuracy(*command, options);
    addBenchSpeed(*command, options);
    addBenchEffects(*command, options);
    command->footer("Example:\n  eikonal bench effects volumes/prism.toml --svg ladder.svg");
}

} // namespace eikonal

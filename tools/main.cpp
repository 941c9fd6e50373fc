// The executable: parses the command line, runs one command, turns failures into messages and exit codes.

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include <CLI/CLI.hpp>

#include "common/error.h"
#include "common/interrupt.h"
#include "tools/command_bake.h"
#include "tools/command_bench.h"
#include "tools/command_figure.h"
#include "tools/command_info.h"
#include "tools/command_render.h"
#include "tools/command_trace.h"
#include "tools/command_view.h"
#include "tools/command_voxelize.h"
#include "tools/program.h"
#include "tools/usage.h"

namespace {

using eikonal::ExitCode;

void addCommands(CLI::App& program, eikonal::ProgramOptions& options) {
    program.add_flag("-q,--quiet", options.quiet, "no progress on stderr");
    program.set_version_flag("--version", eikonal::versionText, "versions of the libraries, and the renderer");
    program.require_subcommand(1);
    program.fallthrough();
    program.footer("Exit codes: 0 done, 1 failure, 2 wrong usage, 3 bad input, 4 no usable OpenGL 4.5.\n"
                   "`eikonal COMMAND --help` gives a command's options and an example.");
    eikonal::addVoxelizeCommand(program, options);
    eikonal::addBakeCommand(program, options);
    eikonal::addRenderCommand(program, options);
    eikonal::addViewCommand(program, options);
    eikonal::addTraceCommand(program, options);
    eikonal::addInfoCommand(program, options);
    eikonal::addBenchCommand(program, options);
    eikonal::addFigureCommand(program, options);
}

/// That is no option.
std::string_view firstWord(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (argv[i][0] != '-') return argv[i];
    }
    return {};
}

ExitCode parseAndRun(int argc, char** argv) {
    CLI::App program("Light in continuously varying refractive media: bakes volume caustics, renders curved rays.",
                     "eikonal");
    eikonal::ProgramOptions options;
    addCommands(program, options);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& request) {
        program.exit(request);
    } catch (const CLI::ParseError& error) {
        eikonal::reportError(eikonal::usageMessage(program, error, firstWord(argc, argv)));
        return ExitCode::kUsage;
    }
    return ExitCode::kDone;
}

ExitCode run(int argc, char** argv) {
    try {
        const ExitCode code = parseAndRun(argc, argv);
        std::cout.flush();
        if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            throw eikonal::failure("stdout: expected to write the results; the device took no more (is the disk full?)");
        }
        return code;
    } catch (const eikonal::Error& error) {
        eikonal::reportError(error.what());
        return error.code();
    } catch (const std::bad_alloc&) {
        eikonal::reportError("out of memory: try a lower domain.resolution");
    } catch (const std::exception& error) {
        eikonal::reportError(error.what());
    }
    return ExitCode::kFailure;
}

} // namespace

int main(int argc, char** argv) {
    eikonal::installInterruptHandlers();
    return int(run(argc, argv));
}

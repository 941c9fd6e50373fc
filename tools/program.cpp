#include "tools/program.h"

#include <fmt/core.h>

#include "common/error.h"
#include "common/gpu/context.h"
#include "tools/terminal.h"

namespace eikonal {

namespace {

void printLabelled(std::string_view label, std::string_view colour, std::string_view message) {
    if (stderrTakesColour()) {
        fmt::print(stderr, "\x1b[1;{}m{}:\x1b[0m {}\n", colour, label, message);
    } else {
        fmt::print(stderr, "{}: {}\n", label, message);
    }
}

std::string rendererOrWhyNot() {
    try {
        return gpu::Context::windowless().rendererName();
    } catch (const Error& error) {
        return fmt::format("none ({})", error.what());
    }
}

} // namespace

void note(const ProgramOptions& options, std::string_view message) {
    if (!options.quiet) {
        fmt::print(stderr, "{}\n", message);
    }
}

void warn(std::string_view message) { printLabelled("warning", "33", message); }

void reportError(std::string_view message) { printLabelled("error", "31", message); }

std::string versionText() {
    return fmt::format("eikonal {}\nlibraries: {}\nrenderer: {}", kVersion, EIKONAL_LIBRARIES, rendererOrWhyNot());
}

} // namespace eikonal

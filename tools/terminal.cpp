#include "tools/terminal.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <fmt/core.h>
#include <unistd.h>

namespace eikonal {

bool stderrIsTerminal() { return isatty(STDERR_FILENO) != 0; }

bool stderrTakesColour() {
    const char* noColour = std::getenv("NO_COLOR");
    return stderrIsTerminal() && (noColour == nullptr || *noColour == '\0');
}

Progress::Progress(const ProgramOptions& options) : quiet_(options.quiet), terminal_(stderrIsTerminal()) {}

Progress::~Progress() { finish(); }

void Progress::update(std::string_view stage, double fraction) {
    if (quiet_) {
        return;
    }
    const bool newStage = stage != stage_;
    stage_ = stage;
    if (!terminal_) {
        if (newStage) {
            fmt::print(stderr, "{}\n", stage_);
        }
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (newStage || fraction >= 1.0 || now - lastDrawn_ > std::chrono::milliseconds(100)) {
        lastDrawn_ = now;
        draw(std::clamp(fraction, 0.0, 1.0));
    }
}

void Progress::draw(double fraction) {
    constexpr int kBarCells = 30;
    const int filled = int(fraction * kBarCells);
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} %  {}\x1b[K", "", filled, "", kBarCells - filled, 100.0 * fraction,
               stage_);
    std::fflush(stderr);
    lineOpen_ = true;
}

void Progress::finish() {
    if (lineOpen_) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
        lineOpen_ = false;
    }
}

void warnOf(const std::vector<std::string>& warnings, Progress& progress) {
    if (!warnings.empty()) progress.finish();
    for (const std::string& warning : warnings) {
        warn(warning);
    }
}

} // namespace eikonal

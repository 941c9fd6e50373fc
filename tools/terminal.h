#pragma once
// Progress of long work on stderr: one line that is redrawn on a terminal, plain lines elsewhere, nothing with --quiet.

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "tools/program.h"

namespace eikonal {

/// True if stderr is a terminal, where lines may be redrawn.
bool stderrIsTerminal();
/// True if stderr is a terminal and NO_COLOR is unset or empty.
bool stderrTakesColour();

class Progress {
public:
    explicit Progress(const ProgramOptions& options);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Where the work stands: the stage's name and the fraction of it that is done, 0 to 1.
    void update(std::string_view stage, double fraction);
    /// Ends the redrawn line; messages may follow.
    void finish();

private:
    void draw(double fraction);

    bool quiet_ = false;
    bool terminal_ = false;
    bool lineOpen_ = false;
    std::string stage_;
    std::chrono::steady_clock::time_point lastDrawn_{};
};

/// Each as a line on stderr, after the line that is redrawn, with --quiet too.
void warnOf(const std::vector<std::string>& warnings, Progress& progress);

} // namespace eikonal

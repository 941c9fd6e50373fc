#pragma once
// Runs the executable as a user would, and gives back what it said.

#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/support/temporary_folder.h"

namespace eikonal::test {

struct RunResult {
    int exitCode = -1;  ///< -1: ended by a signal
    int signal = 0;
    std::string out;
    std::string err;
};

struct RunOptions {
    std::vector<std::string> environment;  ///< "NAME=value", added to this process's
    std::string standardOutput;            ///< file that takes stdout; empty: captured
    std::vector<std::string> launcher;     ///< program and arguments that start the executable; empty: none
    std::string workingFolder;             ///< empty: this process's
    std::function<void(pid_t)> whileRunning;  ///< called once after the start, for signals
};

RunResult runEikonal(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Arguments that name a scene of volumes/: the file, and where it needs one the volume of a mesh, made in `folder`.
std::vector<std::string> shippedScene(const std::string& name, const TemporaryFolder& folder);

/// A scene that bakes and renders in a fraction of a second: a small glass ball in smoke, one beam.
extern const std::string kSmallScene;

} // namespace eikonal::test

#pragma once
// Runs the executable as a user would, and gives back what it said.

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

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

/// A new empty folder, removed with its contents at the end of the scope.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Path of a file in it, as text for the command line.
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file and gives its path.
    std::string write(const std::string& name, const std::string& text) const;
    /// Names of everything in it, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

std::string readText(const std::filesystem::path& path);

/// Arguments that name a scene of volumes/: the file, and where it needs one the volume of a mesh, made in `folder`.
std::vector<std::string> shippedScene(const std::string& name, const TemporaryFolder& folder);

/// A scene that bakes and renders in a fraction of a second: a small glass ball in smoke, one beam.
extern const std::string kSmallScene;

} // namespace eikonal::test

#include "tests/tools/run_eikonal.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace eikonal::test {

namespace {

[[noreturn]] void becomeEikonal(std::vector<char*>& arguments, const RunOptions& options, const std::string& out,
                                const std::string& err) {
    for (const std::string& variable : options.environment) {
        ::putenv(const_cast<char*>(variable.c_str()));
    }
    if (!options.workingFolder.empty() && ::chdir(options.workingFolder.c_str()) != 0) ::_exit(126);
    const int outFile = ::open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    const int errFile = ::open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(outFile, STDOUT_FILENO);
    ::dup2(errFile, STDERR_FILENO);
    ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
}

} // namespace

const std::string kSmallScene = R"(
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
resolution = 16
[medium]
scattering = 0.3
[[object]]
shape = "sphere"
radius = 0.5
ior = 1.5
[[light]]
type = "directional"
direction = [1, 0, 0]
[render]
size = [32, 24]
)";

RunResult runEikonal(const std::vector<std::string>& arguments, const RunOptions& options) {
    const TemporaryFolder folder;
    const std::string err = folder.file("stderr");
    const std::string out = options.standardOutput.empty() ? folder.file("stdout") : options.standardOutput;
    std::vector<std::string> copies = options.launcher;
    copies.emplace_back(EIKONAL_BINARY);
    copies.insert(copies.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    std::transform(copies.begin(), copies.end(), std::back_inserter(argv), [](std::string& text) { return text.data(); });
    argv.push_back(nullptr);

    const pid_t child = ::fork();
    if (child < 0) {
        throw std::runtime_error("fork failed");
    }
    if (child == 0) {
        becomeEikonal(argv, options, out, err);
    }
    if (options.whileRunning) {
        options.whileRunning(child);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    RunResult result;
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.out = options.standardOutput.empty() ? readText(out) : std::string();
    result.err = readText(err);
    return result;
}

std::vector<std::string> shippedScene(const std::string& name, const TemporaryFolder& folder) {
    std::vector<std::string> arguments{std::string(EIKONAL_SCENES) + "/" + name + ".toml"};
    if (name == "amber_figure" || name == "amber_inclusions") {
        const std::string mesh = folder.file("trefoil.obj");
        const std::string volume = folder.file("trefoil.vdb");
        const RunResult figure = runEikonal({"figure", "-o", mesh});
        const RunResult voxelize = runEikonal({"voxelize", mesh, "-o", volume, "--ior", "1.54", "--absorption", "0.4,1.6,5",
                                               "--resolution", "64"});
        if (figure.exitCode != 0 || voxelize.exitCode != 0) {
            throw std::runtime_error("the figure of " + name + " cannot be made: " + figure.err + voxelize.err);
        }
        arguments.insert(arguments.end(), {"--set", "object.0.volume=" + volume});
    }
    return arguments;
}

} // namespace eikonal::test

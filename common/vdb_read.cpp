// Reading VDB files through a process of its own. OpenVDB 10 crashes, hangs or takes gigabytes on damaged files, and may
// corrupt the heap without a sign, so this process never parses them: a separate executable does and sends plain arrays.
// It is started anew, not forked: a fork would inherit the threads' locks of the GL driver and of TBB.

#include "common/vdb_io.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/companion.h"
#include "common/error.h"
#include "common/interrupt.h"
#include "common/vdb_transfer.h"

namespace fs = std::filesystem;

namespace eikonal {
namespace {

void requireReadableFile(const fs::path& path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw badInput(fmt::format("{}: no such file", path.string()));
    if (!fs::is_regular_file(path, ignored))
        throw badInput(fmt::format("{}: expected a VDB file, found a folder or device", path.string()));
    if (access(path.c_str(), R_OK) != 0)
        throw badInput(fmt::format("{}: cannot be read: {}", path.string(), std::generic_category().message(errno)));
    if (fs::file_size(path, ignored) == 0)
        throw badInput(fmt::format("{}: expected a VDB file, found an empty one", path.string()));
}

/// The reader process and the pipe from it. Killed if not waited for.
class Reader {
public:
    Reader(const fs::path& file, VdbRequest request);
    ~Reader() {
        close(pipe_);
        if (process_ > 0) {
            kill(process_, SIGKILL);
            wait();
        }
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool read(void* data, std::size_t bytes);
    std::string readText();
    int wait();

private:
    ssize_t readSome(void* data, std::size_t bytes);

    pid_t process_ = -1;
    int pipe_ = -1;
};

Reader::Reader(const fs::path& file, VdbRequest request) {
    const fs::path program = findCompanion("eikonal_vdb_reader", EIKONAL_COMPANION_FOLDER);
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw failure("cannot make a pipe: " + std::generic_category().message(errno));
    pipe_ = ends[0];
    fcntl(pipe_, F_SETPIPE_SZ, 1 << 20);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::string name = program.string(), verb = request == VdbRequest::kSummary ? "summary" : "grids",
                argument = file.string();
    const std::array<char*, 4> arguments{name.data(), verb.data(), argument.data(), nullptr};
    const int code = posix_spawn(&process_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (code != 0) {
        process_ = -1;
        close(pipe_);
        throw failure(fmt::format("cannot run {}: {}", name, std::generic_category().message(code)));
    }
}

ssize_t Reader::readSome(void* data, std::size_t bytes) {
    for (;;) {
        throwIfInterrupted();
        pollfd waiting{pipe_, POLLIN, 0};
        if (poll(&waiting, 1, 200) <= 0)
            continue;
        const ssize_t count = ::read(pipe_, data, bytes);
        if (count >= 0 || errno != EINTR)
            return count;
    }
}

bool Reader::read(void* data, std::size_t bytes) {
    auto* next = static_cast<char*>(data);
    while (bytes > 0) {
        const ssize_t count = readSome(next, bytes);
        if (count <= 0)
            return false;
        next += count;
        bytes -= std::size_t(count);
    }
    return true;
}

/// A message: short by intention, so what goes beyond is dropped.
std::string Reader::readText() {
    std::string text(4096, '\0');
    std::size_t length = 0;
    while (length < text.size()) {
        const ssize_t count = readSome(text.data() + length, text.size() - length);
        if (count <= 0)
            break;
        length += std::size_t(count);
    }
    text.resize(length);
    return text;
}

int Reader::wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
}

Error damaged(const fs::path& path, int status) {
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGALRM))
        return badInput(fmt::format("{}: damaged VDB file: reading it does not end", path.string()));
    if (WIFSIGNALED(status))
        return badInput(fmt::format("{}: damaged VDB file: reading it crashes (signal {})", path.string(), WTERMSIG(status)));
    return badInput(fmt::format("{}: damaged VDB file", path.string()));
}

/// Runs the reader and lets `receive` take its answer; a complaint from there is thrown as badInput.
template <class Receive>
void readThrough(const fs::path& path, VdbRequest request, Receive&& receive) {
    requireReadableFile(path);
    Reader reader(path, request);
    char tag = 0;
    const bool answered = reader.read(&tag, 1);
    if (answered && tag == kComplaintTag)
        throw badInput(reader.readText());
    const bool complete =
        answered && tag == kDataTag && receive([&](void* data, std::size_t bytes) { return reader.read(data, bytes); });
    const int status = reader.wait();
    throwIfInterrupted();
    if (!complete || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw damaged(path, status);
}

} // namespace

VdbFile readVdb(const fs::path& path) {
    VdbFile file;
    readThrough(path, VdbRequest::kGrids, [&](const ReadBytes& read) { return receiveVdb(read, file); });
    return file;
}

nlohmann::json vdbSummary(const fs::path& path) {
    nlohmann::json summary;
    readThrough(path, VdbRequest::kSummary, [&](const ReadBytes& read) { return receiveJson(read, summary); });
    return summary;
}

} // namespace eikonal

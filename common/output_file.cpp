#include "common/output_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/error.h"
#include "common/interrupt.h"

namespace fs = std::filesystem;

namespace eikonal {
namespace {

Error cannotWrite(const fs::path& target, const std::string& why) {
    return failure(fmt::format("cannot write {}: {}", target.string(), why));
}

std::string systemMessage(int code) { return std::generic_category().message(code); }

/// A link stays a link: what it points to is replaced.
fs::path followLinks(const fs::path& target) {
    std::error_code ignored;
    if (!fs::is_symlink(target, ignored))
        return target;
    const fs::path resolved = fs::weakly_canonical(target, ignored);
    return ignored ? target : resolved;
}

/// Creates an empty file of a new name beside the target, with the mode that any new file gets.
fs::path createBeside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        const std::string name = fmt::format(".{}.{}-{}{}", target.stem().string(), getpid(), counter++,
                                             target.extension().string());
        const fs::path candidate = target.parent_path() / name;
        const int file = open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            close(file);
            return candidate;
        }
        if (errno != EEXIST)
            throw cannotWrite(target, systemMessage(errno));
    }
}

/// A disk may report that it is full as late as here.
void flushToDisk(const fs::path& file, const fs::path& target) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        throw cannotWrite(target, systemMessage(errno));
    const bool flushed = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
    const int code = errno;
    close(descriptor);
    if (!flushed)
        throw cannotWrite(target, systemMessage(code));
}

void writeAll(const fs::path& file, const fs::path& target, std::string_view contents) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor < 0)
        throw cannotWrite(target, systemMessage(errno));
    while (!contents.empty()) {
        const ssize_t written = write(descriptor, contents.data(), contents.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0) {
            const int code = errno;
            close(descriptor);
            throw cannotWrite(target, systemMessage(code));
        }
        contents.remove_prefix(std::size_t(written));
    }
    if (close(descriptor) != 0)
        throw cannotWrite(target, systemMessage(errno));
}

} // namespace

bool writtenInPlace(const fs::path& target) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

OutputFile::OutputFile(const fs::path& target) : target_(followLinks(target)) {
    std::error_code ignored;
    if (target.empty() || fs::is_directory(target_, ignored) || !target_.has_filename())
        throw cannotWrite(target, "expected a file name, found a folder");
    if (writtenInPlace(target_)) {
        temporary_ = target_;
        return;
    }
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        throw cannotWrite(target, fmt::format("there is no folder {}", folder.string()));
    temporary_ = createBeside(target_);
    signalSlot_ = removeOnSignal(fs::absolute(temporary_));
}

OutputFile::~OutputFile() {
    if (!temporary_.empty() && temporary_ != target_) {
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
    keepOnSignal(signalSlot_);
}

void OutputFile::commit() {
    throwIfInterrupted();
    flushToDisk(temporary_, target_);
    if (temporary_ != target_ && std::rename(temporary_.c_str(), target_.c_str()) != 0)
        throw cannotWrite(target_, systemMessage(errno));
    temporary_.clear();
}

void requireWritable(const fs::path& target) { const OutputFile probe(target); }

void writeFile(const fs::path& target, std::string_view contents) {
    OutputFile output(target);
    writeAll(output.path(), output.target(), contents);
    output.commit();
}

} // namespace eikonal

#pragma once
// Outputs appear whole or not at all: they are written beside the target under a temporary name and renamed.

#include <filesystem>
#include <string_view>

namespace eikonal {

/// A file in the making. Write to path(), then commit(); without commit() the target stays as it was and the temporary
/// is removed, on SIGINT and SIGTERM too (common/interrupt.h).
class OutputFile {
public:
    /// Throws failure naming the path if its folder is missing or cannot be written to.
    explicit OutputFile(const std::filesystem::path& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// The temporary, in the target's folder, with the target's extension.
    const std::filesystem::path& path() const { return temporary_; }
    const std::filesystem::path& target() const { return target_; }

    /// Forces the data to disk and renames. Throws failure where the disk is full, leaving nothing behind.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int signalSlot_ = -1;
};

/// Devices and pipes are: renaming over /dev/null would replace it.
bool writtenInPlace(const std::filesystem::path& target);

/// Throws failure naming the path if no file could be written there. For use before long work.
void requireWritable(const std::filesystem::path& target);

/// Writes text or bytes through an OutputFile.
void writeFile(const std::filesystem::path& target, std::string_view contents);

} // namespace eikonal

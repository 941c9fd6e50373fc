#include "viewer/window/file_watch.h"

#include <system_error>
#include <utility>

namespace eikonal::window {

namespace {

std::filesystem::file_time_type stampOf(const std::filesystem::path& file) {
    std::error_code missing;
    return std::filesystem::last_write_time(file, missing);
}

} // namespace

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
    std::map<std::filesystem::path, std::filesystem::file_time_type> stamps;
    for (const std::filesystem::path& file : files) {
        const auto known = stamps_.find(file);
        stamps.emplace(file, known == stamps_.end() ? stampOf(file) : known->second);
    }
    stamps_ = std::move(stamps);
}

bool FileWatch::haveChanged() {
    bool changed = false;
    for (auto& [file, stamp] : stamps_) {
        const auto now = stampOf(file);
        changed = changed || now != stamp;
        stamp = now;
    }
    return changed;
}

} // namespace eikonal::window

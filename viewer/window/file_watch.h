#pragma once
// Files that may be changed by others while the window is open.

#include <filesystem>
#include <map>
#include <vector>

namespace eikonal::window {

class FileWatch {
public:
    /// Watches these instead of those before; what has happened to the ones that stay is not forgotten.
    void watch(const std::vector<std::filesystem::path>& files);
    /// Whether one of them is another one than when this was last asked; one that is missing differs from any other.
    bool haveChanged();

private:
    std::map<std::filesystem::path, std::filesystem::file_time_type> stamps_;
};

} // namespace eikonal::window

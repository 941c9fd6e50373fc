#include "tools/frame_name.h"

#include <filesystem>

#include <fmt/core.h>

namespace eikonal {

bool hasFrameNumber(const std::string& pattern) {
    return std::filesystem::path(pattern).filename().string().find('#') != std::string::npos;
}

std::string frameName(const std::string& pattern, int frame) {
    const std::size_t last = pattern.find_last_of('#');
    const std::size_t before = pattern.find_last_not_of('#', last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return pattern.substr(0, first) + fmt::format("{:0{}}", frame, last + 1 - first) + pattern.substr(last + 1);
}

} // namespace eikonal

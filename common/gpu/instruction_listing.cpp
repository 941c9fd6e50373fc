#include "common/gpu/instruction_listing.h"

#include <algorithm>
#include <array>

namespace eikonal::gpu {

namespace {

constexpr std::string_view kBegin = "!!NVcp", kEnd = "END";
// What statements that declare begin with.
constexpr std::array<std::string_view, 17> kDeclarations = {
    "OPTION", "GROUP_SIZE", "SHARED_MEMORY", "SHARED", "PARAM",      "STORAGE", "CBUFFER", "BUFFER", "TEXTURE",
    "IMAGE",  "ATTRIB",     "OUTPUT",        "TEMP",   "SHORT TEMP", "INT TEMP", "LONG TEMP", "ALIAS"};

bool isInstruction(std::string_view line) {
    const auto begins = [&](std::string_view word) { return line.starts_with(word) && line[word.size()] == ' '; };
    return line.ends_with(';') && std::none_of(kDeclarations.begin(), kDeclarations.end(), begins);
}

} // namespace

std::optional<std::size_t> listedInstructions(std::string_view programBinary) {
    std::size_t at = programBinary.find(kBegin);
    if (at == std::string_view::npos) return std::nullopt;
    std::size_t count = 0;
    while (at < programBinary.size()) {
        const std::size_t end = std::min(programBinary.find('\n', at), programBinary.size());
        const std::string_view line = programBinary.substr(at, end - at);
        if (line == kEnd) return count;
        count += isInstruction(line) ? 1 : 0;
        at = end + 1;
    }
    return std::nullopt;  // a listing without its end
}

} // namespace eikonal::gpu

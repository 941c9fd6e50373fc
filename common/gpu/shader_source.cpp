#include "common/gpu/shader_source.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace eikonal::gpu {

namespace {

// The names that shaders/physics is written in; C++ defines them in common/physics.h.
constexpr std::string_view kPreamble =
    "#define real float\n#define real2 vec2\n#define real3 vec3\n#define real4 vec4\n";
constexpr std::string_view kRootFolder = "shaders/";

std::string_view embeddedText(std::string_view name) {
    const auto& table = embeddedShaders();
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.name == name; });
    if (found == table.end()) throw std::logic_error("no shader is named '" + std::string(name) + "'");
    return found->text;
}

std::string_view trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

/// The name between the quotes of an include line, below shaders/ with or without that folder in front.
std::string_view includedName(std::string_view directive) {
    const auto open = directive.find('"');
    const auto close = directive.find('"', open + 1);
    if (open == std::string_view::npos || close == std::string_view::npos) return {};
    std::string_view name = directive.substr(open + 1, close - open - 1);
    if (name.starts_with(kRootFolder)) name.remove_prefix(kRootFolder.size());
    return name;
}

void appendExpanded(std::string_view name, std::set<std::string, std::less<>>& seen, std::string& out) {
    if (!seen.emplace(name).second) return;
    std::string_view text = embeddedText(name);
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view directive = trimmed(line);
        if (directive.starts_with("#pragma once")) continue;
        if (directive.starts_with("#include")) {
            // <...> is a C++ header that a file of shaders/shared/ asks for.
            if (const auto included = includedName(directive); !included.empty()) appendExpanded(included, seen, out);
            continue;
        }
        out.append(line).push_back('\n');
    }
}

} // namespace

std::string kernelSource(std::string_view name, const std::vector<std::string>& defines) {
    std::string source = "#version 450 core\n";
    for (const auto& define : defines) source += "#define " + define + "\n";
    source += kPreamble;
    std::set<std::string, std::less<>> seen;
    appendExpanded(name, seen, source);
    return source;
}

} // namespace eikonal::gpu

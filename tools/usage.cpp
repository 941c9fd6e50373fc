#include "tools/usage.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

#include <fmt/core.h>

#include "common/file_kind.h"
#include "common/output_file.h"
#include "common/spelling.h"

namespace eikonal {

CLI::Validator aboveZero() {
    const auto check = [](const std::string& text) {
        double value = 0.0;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool isAbove = status == std::errc() && end == text.data() + text.size() && value > 0.0;
        return isAbove ? std::string() : fmt::format("expected a number above 0, found '{}'", text);
    };
    return CLI::Validator(check, "");
}

void requireExtension(const std::string& option, const std::string& file, std::string_view extension) {
    if (extensionOf(file) != extension && !writtenInPlace(file)) {
        throw CLI::ValidationError(option, fmt::format("expected a name that ends in {}, found '{}'", extension, file));
    }
}

void requireApart(const std::string& option, const std::string& file, std::initializer_list<std::string> others) {
    const auto whole = [](const std::string& name) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(name, ignored);
    };
    for (const std::string& other : others) {
        if (!other.empty() && whole(file) == whole(other) && !writtenInPlace(file)) {
            throw CLI::ValidationError(option, fmt::format("expected a file of its own, found '{}', which is read or written besides", file));
        }
    }
}

std::string usageMessage(const CLI::App& program, const CLI::ParseError& error, std::string_view word) {
    std::vector<std::string_view> commands;
    for (const CLI::App* command : program.get_subcommands({})) {
        commands.push_back(command->get_name());
    }
    if (std::find(commands.begin(), commands.end(), word) != commands.end()) {
        return fmt::format("{}\nRun `eikonal {} --help` for more information.", error.what(), word);
    }
    const std::string found = word.empty() ? "none" : fmt::format("'{}'{}", word, didYouMean(word, commands));
    return fmt::format("expected a command, one of {}; found {}\nRun `eikonal --help` for more information.", listNames(commands), found);
}

} // namespace eikonal

#pragma once
// What every command of the executable shares: global options, and messages to the person in front of it.

#include <string>
#include <string_view>

namespace eikonal {

/// Options that stand before or after the command's name.
struct ProgramOptions {
    bool quiet = false;  ///< no progress
};

/// The creator that written files name.
inline constexpr std::string_view kCreator = "Eikonal";
inline constexpr std::string_view kVersion = EIKONAL_VERSION;

/// A line on stderr, unless --quiet: what was done, beside the data that goes to stdout.
void note(const ProgramOptions& options, std::string_view message);
void warn(std::string_view message);
void reportError(std::string_view message);

/// Versions of the program and its libraries, and the renderer where a context can be made.
std::string versionText();

} // namespace eikonal

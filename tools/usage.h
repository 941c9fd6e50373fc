#pragma once
// What the commands' options have in common, and what is said about wrong ones.

#include <initializer_list>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace eikonal {

/// Of an option's value: a number above 0.
CLI::Validator aboveZero();

/// Throws CLI::ValidationError unless a file that is to be written ends in `extension`, such as ".vdb", or is a device or a pipe.
void requireExtension(const std::string& option, const std::string& file, std::string_view extension);

/// Throws CLI::ValidationError where a file that is to be written is one of `others`, which the command reads or writes besides.
void requireApart(const std::string& option, const std::string& file, std::initializer_list<std::string> others);

/// For a command line that cannot be understood, whose first word but for options is `word`.
std::string usageMessage(const CLI::App& program, const CLI::ParseError& error, std::string_view word);

} // namespace eikonal

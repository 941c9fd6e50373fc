#pragma once
// Where a bench leaves what it has measured: a table, and a chart of it.

#include <string>

#include <CLI/CLI.hpp>

namespace eikonal::bench {

struct TableFiles {
    std::string csv;  ///< empty: stdout
    std::string svg;  ///< empty: none
};

/// `-o` and `--svg`.
void addTableFiles(CLI::App& command, TableFiles& files, const std::string& chart);

/// Throws failure where one could not be written. For use before long work.
void requireWritable(const TableFiles& files);

/// Throws failure for a full disk.
void write(const TableFiles& files, const std::string& csv, const std::string& svg);

} // namespace eikonal::bench

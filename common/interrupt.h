#pragma once
// Ctrl-C and SIGTERM: long work polls, temporaries are removed, the program ends with exit code 1.

#include <filesystem>

namespace eikonal {

/// Installs handlers for SIGINT and SIGTERM. The first signal raises the flag, for work to end in order; a second one
/// removes unfinished outputs and ends the process at once.
void installInterruptHandlers();

/// True once a signal has arrived.
bool interrupted();

/// Throws failure("interrupted") once a signal has arrived. Cheap: for use in every loop that can take long.
void throwIfInterrupted();

/// Registers a file that the second signal removes; returns a slot, or -1 when all are taken.
int removeOnSignal(const std::filesystem::path& file);
void keepOnSignal(int slot);

} // namespace eikonal

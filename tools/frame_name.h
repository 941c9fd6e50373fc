#pragma once
// Names of the files of a numbered sequence.

#include <string>

namespace eikonal {

/// True if the file's name (not its folder's) holds a '#'.
bool hasFrameNumber(const std::string& pattern);

/// The pattern with the last run of '#' in the file's name as the frame's number, zero-padded to the run's length.
std::string frameName(const std::string& pattern, int frame);

} // namespace eikonal

#pragma once
// What comes from outside, as bytes: each intake reads them or calls them bad input, and does nothing else. The fuzzers
// (fuzz_main.cpp) and the regression test (test_regressions.cpp) go through the same functions.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eikonal::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// The text of a scene; what it says is written and read again, and must say the same. Nothing is composed, no file opened.
void readScene(Bytes bytes);

/// A VDB file as the program reads it: through the reader process, because OpenVDB does not survive every file.
void readVdbFile(Bytes bytes);

/// What a reader process that has run wild may send.
void receiveVdbAnswer(Bytes bytes);

/// A mesh: the first byte chooses among the formats, the rest is the file. Holes are closed, as for voxels.
void readMesh(Bytes bytes);

} // namespace eikonal::fuzz

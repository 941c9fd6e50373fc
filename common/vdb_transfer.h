#pragma once
// How the reader process hands grids to the program: a tag, a length, a JSON header, then raw
// floats grid after grid.

#include <cstdio>
#include <functional>

#include <nlohmann/json_fwd.hpp>

#include "common/vdb_io.h"

namespace eikonal {

/// The first byte of an answer: data follow, or a message for the user.
constexpr char kDataTag = 'D';
constexpr char kComplaintTag = 'E';

/// What the reader process is asked for.
enum class VdbRequest { kGrids, kSummary };

/// Sends grids or a summary, after the tag. Throws failure when the other side is gone.
void sendVdb(std::FILE* stream, const VdbFile& file);
void sendJson(std::FILE* stream, const nlohmann::json& header);

/// Fills `bytes` bytes at `data`; false at the end of the stream.
using ReadBytes = std::function<bool(void* data, std::size_t bytes)>;

/// Receive what was sent; false where the stream ends early or makes no sense.
bool receiveVdb(const ReadBytes& read, VdbFile& file);
bool receiveJson(const ReadBytes& read, nlohmann::json& header);

} // namespace eikonal

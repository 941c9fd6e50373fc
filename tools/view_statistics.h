#pragma once
// What `eikonal view --stats` writes: how quickly the window answered (docs/viewer.md).

#include <nlohmann/json_fwd.hpp>

#include "viewer/window/response.h"

namespace eikonal {

/// Medians and the longest of frames and drags, null where there were none; every refinement, the opening first.
nlohmann::json viewJson(const window::ResponseRecord& record);

} // namespace eikonal

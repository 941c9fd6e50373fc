#pragma once
// Boxes side by side in one volume.

#include <vector>

#include <glm/glm.hpp>

namespace eikonal {

struct Atlas {
    glm::ivec3 size{1};
    std::vector<glm::ivec3> first;  ///< lower corner of each box
};

/// Packs boxes of these sizes in rows, rows in layers, the tallest first: no larger along x and y than the largest box while the
/// layers' heights sum up to no more than `mostAlongSide`, and twice and more of that where they would.
Atlas packed(const std::vector<glm::ivec3>& sizes, int mostAlongSide);

} // namespace eikonal

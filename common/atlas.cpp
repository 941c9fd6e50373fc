#include "common/atlas.h"

#include <algorithm>
#include <numeric>

namespace eikonal {
namespace {

/// Boxes by descending height, then depth of their rows.
std::vector<std::size_t> tallestFirst(const std::vector<glm::ivec3>& sizes) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return sizes[a].z != sizes[b].z ? sizes[a].z > sizes[b].z : sizes[a].y > sizes[b].y;
    });
    return order;
}

/// All boxes within `across` along x and y, as high as that takes.
Atlas packedWithin(const glm::ivec2& across, const std::vector<glm::ivec3>& sizes) {
    Atlas atlas{glm::ivec3(across, 0), std::vector<glm::ivec3>(sizes.size())};
    glm::ivec3 next(0);
    int row = 0, layer = 0;  // extents along y and z
    for (const std::size_t box : tallestFirst(sizes)) {
        const glm::ivec3& size = sizes[box];
        if (next.x + size.x > across.x) {
            next = {0, next.y + row, next.z};
            row = 0;
        }
        if (next.y + size.y > across.y) {
            next = {0, 0, next.z + layer};
            row = layer = 0;
        }
        atlas.first[box] = next;
        next.x += size.x;
        row = std::max(row, size.y);
        layer = std::max(layer, size.z);
        atlas.size.z = next.z + layer;
    }
    return atlas;
}

} // namespace

Atlas packed(const std::vector<glm::ivec3>& sizes, int mostAlongSide) {
    if (sizes.empty())
        return {};
    glm::ivec2 across(1);
    for (const glm::ivec3& size : sizes)
        across = glm::max(across, glm::ivec2(size));
    Atlas atlas = packedWithin(across, sizes);
    while (atlas.size.z > mostAlongSide && 2 * std::max(across.x, across.y) <= mostAlongSide) {
        across *= 2;
        atlas = packedWithin(across, sizes);
    }
    return atlas;
}

} // namespace eikonal

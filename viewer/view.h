#pragma once
// The camera's part of the block that all stages read, and the tiles of an image.

#include <vector>

#include "common/scene.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

struct Tile {
    glm::ivec2 origin{0}, size{0};  ///< [pixels]
    std::size_t pixels() const { return std::size_t(size.x) * std::size_t(size.y); }
};

/// Sets camera and image size. A camera that looks along `up`, or at its own position, gets another `up` or direction.
void configureCamera(gpu::ViewBlock& view, const Camera& camera, const glm::ivec2& imageSize);

/// `filmStart`: pixels of the film before the tile's.
void configureTile(gpu::ViewBlock& view, const Tile& tile, std::size_t filmStart);

/// Tiles of at most `mostPixels` that cover an image, row after row.
std::vector<Tile> tilesOf(const glm::ivec2& imageSize, std::size_t mostPixels);

/// The pixels of `region` that follow the first `done`, row after row: whole rows, or a part of one, at most `mostPixels`.
Tile nextTile(const Tile& region, std::size_t done, std::size_t mostPixels);

/// Places in the order of a tile's blocks of rays (shaders/viewer/picture_order.glsl), some of them empty.
gpu::uint placesOfBlocks(const glm::ivec2& tileSize);

} // namespace eikonal::viewer

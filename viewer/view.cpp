#include "viewer/view.h"

#include <algorithm>
#include <cmath>

namespace eikonal::viewer {

namespace {

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double magnitude = glm::length(v);
    return magnitude > 1e-12 ? v / magnitude : otherwise;
}

} // namespace

void configureCamera(gpu::ViewBlock& view, const Camera& camera, const glm::ivec2& imageSize) {
    const glm::dvec3 forward = unitOr(camera.lookAt - camera.position, {0.0, 0.0, -1.0});
    const glm::dvec3 sideways = std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
    const glm::dvec3 fallback = glm::normalize(glm::cross(forward, sideways));
    const glm::dvec3 right = unitOr(glm::cross(forward, camera.up), fallback);
    const double halfHeight = std::tan(glm::radians(camera.fov) / 2.0);
    const double halfWidth = halfHeight * imageSize.x / imageSize.y;
    view.cameraPosition = glm::vec3(camera.position);
    view.cameraForward = glm::vec3(forward);
    view.cameraRight = glm::vec3(right * halfWidth);
    view.cameraUp = glm::vec3(glm::cross(right, forward) * halfHeight);
    view.focusDistance = camera.focusDistance() > 0.0 ? float(camera.focusDistance()) : 1.0f;
    view.imageSize = imageSize;
}

void configureTile(gpu::ViewBlock& view, const Tile& tile, std::size_t filmStart) {
    view.tileOrigin = tile.origin;
    view.tileSize = tile.size;
    view.rayCount = gpu::uint(tile.pixels());
    view.filmStart = gpu::uint(filmStart);
}

std::vector<Tile> tilesOf(const glm::ivec2& imageSize, std::size_t mostPixels) {
    const int most = int(std::clamp<std::size_t>(mostPixels, 1, 1u << 24));
    const int width = std::min(imageSize.x, most);
    const int height = std::max(1, most / std::max(width, 1));
    std::vector<Tile> tiles;
    for (int y = 0; y < imageSize.y; y += height) {
        for (int x = 0; x < imageSize.x; x += width) {
            const glm::ivec2 origin(x, y);
            tiles.push_back({origin, glm::min(glm::ivec2(width, height), imageSize - origin)});
        }
    }
    return tiles;
}

Tile nextTile(const Tile& region, std::size_t done, std::size_t mostPixels) {
    const int most = int(std::clamp<std::size_t>(mostPixels, 1, 1u << 24));
    const glm::ivec2 at(int(done % std::size_t(region.size.x)), int(done / std::size_t(region.size.x)));
    const bool wholeRows = at.x == 0 && most >= region.size.x;
    const glm::ivec2 size = wholeRows ? glm::ivec2(region.size.x, std::min(most / region.size.x, region.size.y - at.y))
                                      : glm::ivec2(std::min(most, region.size.x - at.x), 1);
    return {region.origin + at, size};
}

gpu::uint placesOfBlocks(const glm::ivec2& tileSize) {
    const auto over = [](int all, int each) { return (all + each - 1) / each; };
    const int blocks = over(tileSize.x, gpu::kBlockEdge) * over(tileSize.y, gpu::kBlockEdge);
    return gpu::uint(gpu::kPicturePieces * over(blocks, gpu::kPicturePieces));  // pieces of one length
}

} // namespace eikonal::viewer

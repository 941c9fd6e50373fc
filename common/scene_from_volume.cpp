// A bare volume as a scene: its own box and voxels, a default light, camera and sky.

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/error.h"
#include "common/scene_toml.h"
#include "common/scene_values.h"
#include "common/vdb_io.h"

namespace eikonal {
namespace {

struct Box {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};
};

Box worldBounds(const VdbGrid& grid) {
    Box bounds;
    const glm::dvec3 size(grid.size());
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 point(grid.worldFromIndex * glm::dvec4(side * size - 0.5, 1.0));  // outer edges of the voxels
        bounds.min = glm::min(bounds.min, point);
        bounds.max = glm::max(bounds.max, point);
    }
    return bounds;
}

} // namespace

std::string sceneTextForVolume(const std::filesystem::path& volume) {
    const VdbFile file = readVdb(volume);
    const VdbGrid* ior = file.find("ior");
    if (!ior || !ior->isScalar()) {
        std::string found;
        for (const VdbGrid& grid : file.grids)
            found += fmt::format("{}{} ({})", found.empty() ? "" : ", ", grid.name, grid.typeName);
        throw badInput(fmt::format("{}: expected a float grid 'ior' to render, found {}", volume.string(),
                                   found.empty() ? "no grids" : found));
    }
    if (ior->scalar().values.empty())
        throw badInput(fmt::format("{}: expected active voxels in grid 'ior', found none", volume.string()));
    const Box box = worldBounds(*ior);
    const glm::dvec3 edges = ior->voxelSize();
    const glm::dvec3 extent = box.max - box.min;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const double voxel = std::min({edges.x, edges.y, edges.z});
    const glm::dvec3 center = 0.5 * (box.min + box.max);
    constexpr double kFovDegrees = 35.0;
    // The sphere around the box just fits the picture.
    const double distance = 0.5 * glm::length(extent) / std::sin(glm::radians(0.5 * kFovDegrees));
    const glm::dvec3 eye = center + distance * glm::normalize(glm::dvec3(0.35, 0.3, 1.0));
    return fmt::format("[domain]\nmin = {}\nmax = {}\nresolution = {}\n"
                       "[[object]]\nname = {}\nvolume = {}\n"
                       "[[light]]\ntype = \"directional\"\n"
                       "[camera]\nposition = {}\nlook_at = {}\nfov = {}\n",
                       writeVector(box.min), writeVector(box.max), std::llround(longest / voxel),
                       writeString(volume.stem().string()), writeString(volume.filename().string()), writeVector(eye),
                       writeVector(center), kFovDegrees);
}

} // namespace eikonal

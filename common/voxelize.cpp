#include "common/voxelize.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/error.h"
#include "common/scene_limits.h"
#include "common/vdb_io.h"

namespace eikonal {
namespace {

/// Beyond this many widths b the coverage is within 3e-7 of 0 or 1, near single precision, and set so.
constexpr double kBandWidths = 5.0;
constexpr int kMaxResolution = 2048;

Error outOfRange(const std::string& what) { return Error(ExitCode::kUsage, what); }

void validate(const VoxelizeOptions& options) {
    if (!(options.ior > kLeastIor && options.ior < kLargestIor))
        throw outOfRange(fmt::format("expected a refractive index above {} and below {}, found {}", kLeastIor, kLargestIor, options.ior));
    if (!(options.smoothVoxels >= 0.0 && options.smoothVoxels <= 16.0))
        throw outOfRange(fmt::format("expected a boundary width of 0 to 16 voxels, found {}", options.smoothVoxels));
    if (options.voxelSize && !(*options.voxelSize > 0.0 && std::isfinite(*options.voxelSize)))
        throw outOfRange(fmt::format("expected a voxel size above 0, found {}", *options.voxelSize));
    if (options.paddingVoxels && (*options.paddingVoxels < 0 || *options.paddingVoxels > kMaxResolution))
        throw outOfRange(fmt::format("expected a padding of 0 to {} voxels, found {}", kMaxResolution, *options.paddingVoxels));
    if (options.absorption)
        for (int i = 0; i < 3; ++i)
            if (!((*options.absorption)[i] >= 0.0) || !std::isfinite((*options.absorption)[i]))
                throw outOfRange(fmt::format("expected an absorption of at least 0, found {}", (*options.absorption)[i]));
}

int paddingOf(const VoxelizeOptions& options) {
    return options.paddingVoxels.value_or(int(std::ceil(4.0 * options.smoothVoxels)) + 1);
}

double longestSide(const Bounds& bounds) {
    const glm::dvec3 extent = bounds.max - bounds.min;
    return std::max({extent.x, extent.y, extent.z});
}

void warnOfThinWalls(VoxelizedMesh& result, const Bounds& bounds, const VoxelizeOptions& options) {
    const double voxels = result.walls.thinnest / result.lattice.voxel;
    if (result.walls.thinnest <= 0.0 || voxels >= 2.0)
        return;
    result.warnings.push_back(
        fmt::format("walls as thin as {:.3g} ({:.2g} voxels): thinner than two voxels; --resolution {} or --voxel {:.3g} "
                    "would resolve them",
                    result.walls.thinnest, voxels,
                    result.walls.resolutionForTwoVoxels(longestSide(bounds)) + 2 * paddingOf(options),
                    0.5 * result.walls.thinnest));
}

} // namespace

std::optional<std::string> volumeWarning(double voxelizedVolume, double meshVolume) {
    const double error = voxelizedVolume / meshVolume - 1.0;
    if (std::abs(error) <= 0.02)
        return std::nullopt;
    return fmt::format("the voxels' volume differs from the mesh's by {:+.1f} %: pieces of the mesh overlap, or the "
                       "resolution is too low",
                       100.0 * error);
}

Lattice latticeAround(const Bounds& bounds, const VoxelizeOptions& options) {
    validate(options);
    const int padding = paddingOf(options);
    const glm::dvec3 extent = bounds.max - bounds.min;
    if (!options.voxelSize && (options.resolution < 2 * padding + 4 || options.resolution > kMaxResolution))
        throw outOfRange(fmt::format("expected a resolution of {} to {} voxels (padding takes {}), found {}", 2 * padding + 4,
                                     kMaxResolution, 2 * padding, options.resolution));
    Lattice lattice;
    lattice.voxel = options.voxelSize.value_or(longestSide(bounds) / (options.resolution - 2 * padding));
    const glm::dvec3 inside = glm::ceil(extent / lattice.voxel - 1e-9);
    const glm::dvec3 size = inside + 2.0 * padding;
    if (std::max({size.x, size.y, size.z}) > kMaxResolution)
        throw outOfRange(fmt::format("expected a grid of at most {} voxels a side, found {:.0f} × {:.0f} × {:.0f}: choose a "
                                     "larger voxel size",
                                     kMaxResolution, size.x, size.y, size.z));
    lattice.size = glm::max(glm::ivec3(size), glm::ivec3(1));
    lattice.min = 0.5 * (bounds.min + bounds.max) - 0.5 * lattice.extent();
    return lattice;
}

double coverageFromDistance(double distance, double b, double voxel) {
    if (b > 0.0)
        return 0.5 * std::erfc(distance / (std::sqrt(2.0) * b));
    return std::clamp(0.5 - distance / voxel, 0.0, 1.0);
}

VoxelizedMesh voxelize(const Mesh& closedMesh, const VoxelizeOptions& options) {
    const Bounds bounds = boundsOf(closedMesh);
    VoxelizedMesh result;
    result.lattice = latticeAround(bounds, options);
    const double voxel = result.lattice.voxel, b = options.smoothVoxels * voxel;
    const double band = std::max(1.0, kBandWidths * options.smoothVoxels);
    const DenseGrid<float> distance = signedDistance(closedMesh, result.lattice, glm::dmat4(1.0), band);

    result.ior = DenseGrid<float>(result.lattice.size, 1.0f);
    for (std::size_t i = 0; i < distance.values.size(); ++i) {
        const double d = double(distance.values[i]);
        const bool beyond = std::abs(d) >= 0.9999 * band * voxel;
        const double coverage = beyond ? (d < 0.0 ? 1.0 : 0.0) : coverageFromDistance(d, b, voxel);
        result.ior.values[i] = float(1.0 + coverage * (options.ior - 1.0));
    }
    if (options.absorption) {
        result.absorption = DenseGrid<glm::vec3>(result.lattice.size, glm::vec3(0.0f));
        for (std::size_t i = 0; i < distance.values.size(); ++i)
            result.absorption.values[i] =
                glm::vec3(coverageFromDistance(double(distance.values[i]), 0.0, voxel) * *options.absorption);
    }
    result.meshVolume = meshVolume(closedMesh);
    result.voxelizedVolume = voxelizedVolume(distance, voxel);
    result.walls = wallThickness(closedMesh);
    if (auto warning = volumeWarning(result.voxelizedVolume, result.meshVolume))
        result.warnings.push_back(std::move(*warning));
    warnOfThinWalls(result, bounds, options);
    return result;
}

void writeVoxelized(const std::filesystem::path& path, const VoxelizedMesh& result, const VoxelizeOptions& options,
                    const std::string& source) {
    std::vector<NamedGrid> grids{{"ior", &result.ior, glm::vec3(1.0f), VdbClass::kUnknown}};
    if (!result.absorption.empty())
        grids.push_back({"absorption", &result.absorption, glm::vec3(0.0f), VdbClass::kUnknown});
    writeVdb(path, result.lattice, grids,
             {{"creator", "eikonal voxelize"},
              {"eikonal_ior", options.ior},
              {"eikonal_smooth_voxels", options.smoothVoxels},
              {"eikonal_source", source}});
}

} // namespace eikonal

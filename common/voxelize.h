#pragma once
// A closed mesh to an index field: coverage by signed distance (docs/physics.md, 2).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/lattice.h"
#include "common/mesh.h"

namespace eikonal {

struct VoxelizeOptions {
    double ior = 1.5;                 ///< refractive index inside
    int resolution = 128;             ///< voxels along the grid's longest side, padding included; unused with voxelSize
    std::optional<double> voxelSize;  ///< [mesh units]
    double smoothVoxels = 1.5;        ///< width b of the boundary; 0: coverage by area
    std::optional<glm::dvec3> absorption;  ///< [1 / scene unit], per band
    std::optional<int> paddingVoxels;  ///< around the mesh; unset: 4 b and one more, over which the boundary fades out
};

/// An index field and what the user should hear about it.
struct VoxelizedMesh {
    Lattice lattice;
    DenseGrid<float> ior;
    DenseGrid<glm::vec3> absorption;  ///< empty unless asked for
    double meshVolume = 0.0;          ///< divergence theorem
    double voxelizedVolume = 0.0;
    WallThickness walls;
    std::vector<std::string> warnings;  ///< for the user, one line each
};

/// The lattice around a mesh, centred on it. Throws Error kUsage for options out of range.
Lattice latticeAround(const Bounds& bounds, const VoxelizeOptions& options);

/// Coverage of a boundary of width b around the surface: erfc(d / (sqrt 2 b)) / 2; b = 0: by area within a voxel.
/// `distance` and `b` in the same unit; `voxel` is used where b = 0.
double coverageFromDistance(double distance, double b, double voxel);

/// What to say where voxels do not hold what the mesh does, to 2 %; nothing where they do.
std::optional<std::string> volumeWarning(double voxelizedVolume, double meshVolume);

/// Throws Error kUsage for options out of range, badInput for a mesh that encloses no volume.
VoxelizedMesh voxelize(const Mesh& closedMesh, const VoxelizeOptions& options);

/// Writes grids `ior` (background 1) and, where present, `absorption`, with the options as metadata.
void writeVoxelized(const std::filesystem::path& path, const VoxelizedMesh& result, const VoxelizeOptions& options,
                    const std::string& source);

} // namespace eikonal

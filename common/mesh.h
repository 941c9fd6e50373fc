#pragma once
// Triangle meshes on their way to a signed distance: read, welded, closed, measured.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "common/lattice.h"

namespace eikonal {

struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<glm::ivec3> triangles;  ///< counter-clockwise seen from outside
};

struct Bounds {
    glm::dvec3 min{0.0}, max{0.0};
};

/// What is wrong with a mesh and what was done about it.
struct MeshReport {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t openEdges = 0;         ///< edges of one triangle, before repair
    std::size_t boundaryLoops = 0;     ///< before repair
    std::size_t loopsCapped = 0;
    std::size_t nonManifoldEdges = 0;  ///< edges of more than two triangles
    std::size_t openEdgesLeft = 0;     ///< after repair; 0: closed
    std::vector<std::string> messages;  ///< for the user, one line each; empty when the mesh is clean

    bool closed() const { return openEdgesLeft == 0; }
};

/// Reads OBJ, PLY, STL, glTF: all meshes of the file with their node transforms, vertices welded, degenerate triangles
/// dropped. Throws badInput for a missing or unreadable file, coordinates that are not finite, or no triangles.
Mesh loadMesh(const std::filesystem::path& path);

/// Counts edges and loops; changes nothing.
MeshReport inspectMesh(const Mesh& mesh);

/// Caps each boundary loop with a fan around its centroid. The report tells of the mesh before and after.
MeshReport closeHoles(Mesh& mesh);

Bounds boundsOf(const Mesh& mesh);

/// Volume by the divergence theorem [mesh units³]; positive where triangles face outwards.
double meshVolume(const Mesh& mesh);

/// Signed distance at the voxels' centres [scene units], negative inside, clamped to ±bandVoxels voxels; right also deep
/// inside and in inner cavities. Exact to rounding within the band. The mesh must be closed. `worldFromMesh` is any affine map.
/// Throws badInput if the mesh lies within the lattice's box and encloses no voxel's centre.
DenseGrid<float> signedDistance(const Mesh& mesh, const Lattice& lattice, const glm::dmat4& worldFromMesh,
                                double bandVoxels);

/// Volume of the region of negative distance, boundary voxels by their share max(0, min(1, 1/2 - d/voxel)) [scene units³].
double voxelizedVolume(const DenseGrid<float>& distance, double voxel);

/// Thickness of a mesh's walls: along lines through the solid that enter and leave by nearly opposite faces [mesh units].
struct WallThickness {
    double thinnest = 0.0;  ///< first percentile by area; 0: no such walls
    double median = 0.0;
    /// Voxels along `longestSide` for which the thinnest walls are two voxels; INT_MAX without walls.
    int resolutionForTwoVoxels(double longestSide) const;
};
WallThickness wallThickness(const Mesh& mesh);

/// Loads, closes holes and makes sure that a volume is enclosed. Throws badInput otherwise.
struct SolidMesh {
    Mesh mesh;
    MeshReport report;
};
SolidMesh loadSolidMesh(const std::filesystem::path& path);

/// Writes Wavefront OBJ. Throws failure for an unwritable folder or a full disk.
void writeObj(const std::filesystem::path& path, const Mesh& mesh);

} // namespace eikonal

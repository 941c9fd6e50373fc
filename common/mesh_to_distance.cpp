// Signed distance of a mesh on a lattice: exact distances to triangles, signs from winding numbers along the lattice's
// lines. OpenVDB's meshToVolume passes distances from voxel to voxel, which is off by up to a voxel two voxels away from a
// finely triangulated sphere (index noise along every boundary), fills inner cavities, and takes an open mesh for nothing.

#include "common/mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "common/error.h"
#include "common/interrupt.h"
#include "common/mesh_bvh.h"
#include "common/mesh_scanlines.h"

namespace eikonal {
namespace {

Mesh inIndexSpace(const Mesh& mesh, const Lattice& lattice, const glm::dmat4& worldFromMesh) {
    Mesh result{{}, mesh.triangles};
    result.vertices.reserve(mesh.vertices.size());
    for (const glm::dvec3& v : mesh.vertices)
        result.vertices.push_back((glm::dvec3(worldFromMesh * glm::dvec4(v, 1.0)) - lattice.min) / lattice.voxel - 0.5);
    return result;
}

/// Counts on how many of the three axes' lines each voxel's centre is inside.
DenseGrid<unsigned char> insideVotes(const Mesh& mesh, const glm::ivec3& size) {
    DenseGrid<unsigned char> votes(size, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto lines = scanMesh(mesh, {axis, glm::dvec2(0.0), 1.0, glm::ivec2(size[u], size[v])});
        for (std::size_t line = 0; line < lines.size(); ++line) {
            glm::ivec3 voxel(0);
            voxel[u] = int(line % std::size_t(size[u]));
            voxel[v] = int(line / std::size_t(size[u]));
            int winding = 0;
            auto next = lines[line].begin();
            for (int i = 0; i < size[axis]; ++i) {
                for (; next != lines[line].end() && next->at < double(i); ++next)
                    winding += next->winding;
                voxel[axis] = i;
                votes.at(voxel) = static_cast<unsigned char>(votes.at(voxel) + (winding != 0));
            }
        }
        throwIfInterrupted();
    }
    return votes;
}

bool liesInside(const Bounds& bounds, const glm::ivec3& size) {
    return glm::all(glm::greaterThanEqual(bounds.min, glm::dvec3(-0.5))) &&
           glm::all(glm::lessThanEqual(bounds.max, glm::dvec3(size) - 0.5));
}

/// Distances of one row of voxels, in voxels; the nearest triangle of one voxel is near the nearest of the next.
void fillRow(const MeshBvh& bvh, int j, int k, double band, DenseGrid<float>& distance) {
    int nearest = -1;
    for (int i = 0; i < distance.size.x; ++i)
        distance.at(i, j, k) = float(bvh.distance(glm::dvec3(i, j, k), band, nearest));
}

} // namespace

DenseGrid<float> signedDistance(const Mesh& mesh, const Lattice& lattice, const glm::dmat4& worldFromMesh,
                                double bandVoxels) {
    const Mesh indexed = inIndexSpace(mesh, lattice, worldFromMesh);
    const DenseGrid<unsigned char> votes = insideVotes(indexed, lattice.size);
    if (liesInside(boundsOf(indexed), lattice.size) &&
        std::none_of(votes.values.begin(), votes.values.end(), [](unsigned char v) { return v >= 2; }))
        throw badInput(fmt::format("expected a mesh that encloses a volume, found {} triangles around no voxel's centre: "
                                   "no solid, or too small for voxels of {:.4g}",
                                   mesh.triangles.size(), lattice.voxel));
    const MeshBvh bvh(indexed);
    DenseGrid<float> distance(lattice.size, 0.0f);
    tbb::parallel_for(0, lattice.size.z, [&](int k) {
        for (int j = 0; j < lattice.size.y && !interrupted(); ++j)
            fillRow(bvh, j, k, bandVoxels, distance);
    });
    throwIfInterrupted();
    for (std::size_t i = 0; i < distance.values.size(); ++i)
        distance.values[i] *= float(votes.values[i] >= 2 ? -lattice.voxel : lattice.voxel);
    return distance;
}

double voxelizedVolume(const DenseGrid<float>& distance, double voxel) {
    double voxels = 0.0;
    for (const float d : distance.values)
        voxels += std::clamp(0.5 - double(d) / voxel, 0.0, 1.0);
    return voxels * voxel * voxel * voxel;
}

} // namespace eikonal

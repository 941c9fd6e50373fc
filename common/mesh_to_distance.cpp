// Signed distance of a mesh on a lattice. The distance is OpenVDB's; the sign is ours, from winding numbers along the
// lattice's lines: OpenVDB floods from outside, which fills inner cavities and takes an open mesh for nothing.

#include "common/mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include "common/error.h"
#include "common/interrupt.h"
#include "common/mesh_scanlines.h"

namespace eikonal {
namespace {

/// What meshToVolume asks for: triangles with corners in the space of voxel indices.
struct TriangleAdapter {
    const std::vector<glm::dvec3>& vertices;
    const std::vector<glm::ivec3>& triangles;

    std::size_t polygonCount() const { return triangles.size(); }
    std::size_t pointCount() const { return vertices.size(); }
    std::size_t vertexCount(std::size_t) const { return 3; }
    void getIndexSpacePoint(std::size_t n, std::size_t v, openvdb::Vec3d& position) const {
        const glm::dvec3& p = vertices[std::size_t(triangles[n][int(v)])];
        position = openvdb::Vec3d(p.x, p.y, p.z);
    }
};

struct Interrupter {
    void start(const char* = nullptr) {}
    void end() {}
    bool wasInterrupted(int = -1) { return interrupted(); }
};

Mesh inIndexSpace(const Mesh& mesh, const Lattice& lattice, const glm::dmat4& worldFromMesh) {
    Mesh result{{}, mesh.triangles};
    result.vertices.reserve(mesh.vertices.size());
    for (const glm::dvec3& v : mesh.vertices)
        result.vertices.push_back((glm::dvec3(worldFromMesh * glm::dvec4(v, 1.0)) - lattice.min) / lattice.voxel - 0.5);
    return result;
}

/// Triangles that come within the band of the lattice: the rest of a large mesh would cost memory for nothing.
std::vector<glm::ivec3> trianglesNear(const Mesh& mesh, const glm::ivec3& size, double band) {
    const glm::dvec3 low(-band - 1.0), high = glm::dvec3(size) + band;
    std::vector<glm::ivec3> near;
    for (const glm::ivec3& t : mesh.triangles) {
        const glm::dvec3 &a = mesh.vertices[std::size_t(t.x)], &b = mesh.vertices[std::size_t(t.y)],
                         &c = mesh.vertices[std::size_t(t.z)];
        const glm::dvec3 min = glm::min(glm::min(a, b), c), max = glm::max(glm::max(a, b), c);
        if (glm::all(glm::lessThanEqual(min, high)) && glm::all(glm::greaterThanEqual(max, low)))
            near.push_back(t);
    }
    return near;
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

openvdb::FloatGrid::Ptr bandOf(const Mesh& mesh, const glm::ivec3& size, double band) {
    openvdb::initialize();
    const std::vector<glm::ivec3> near = trianglesNear(mesh, size, band);
    const TriangleAdapter adapter{mesh.vertices, near};
    Interrupter interrupter;
    const auto identity = openvdb::math::Transform::createLinearTransform(1.0);
    auto grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(interrupter, adapter, *identity, float(band) + 1.0f,
                                                                 float(band) + 1.0f,
                                                                 openvdb::tools::UNSIGNED_DISTANCE_FIELD);
    throwIfInterrupted();
    return grid;
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
    const openvdb::FloatGrid::Ptr band = bandOf(indexed, lattice.size, bandVoxels);
    const auto accessor = band->getConstAccessor();
    DenseGrid<float> distance(lattice.size, 0.0f);
    for (int k = 0; k < lattice.size.z; ++k)
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i) {
                const double voxels = std::min(std::abs(double(accessor.getValue({i, j, k}))), bandVoxels);
                const double sign = votes.at(i, j, k) >= 2 ? -1.0 : 1.0;
                distance.at(i, j, k) = float(sign * voxels * lattice.voxel);
            }
    return distance;
}

double voxelizedVolume(const DenseGrid<float>& distance, double voxel) {
    double voxels = 0.0;
    for (const float d : distance.values)
        voxels += std::clamp(0.5 - double(d) / voxel, 0.0, 1.0);
    return voxels * voxel * voxel * voxel;
}

} // namespace eikonal

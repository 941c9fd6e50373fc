#include "common/mesh_generate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <glm/gtc/constants.hpp>

namespace eikonal {
namespace {

/// The trefoil as a curve on a torus's inside and outside; major radius 2, all of it within radius 3.
glm::dvec3 trefoil(double t) {
    return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t)};
}
glm::dvec3 trefoilVelocity(double t) {
    return {std::cos(t) + 4.0 * std::cos(2.0 * t), -std::sin(t) + 4.0 * std::sin(2.0 * t), -3.0 * std::cos(3.0 * t)};
}
glm::dvec3 trefoilAcceleration(double t) {
    return {-std::sin(t) - 8.0 * std::sin(2.0 * t), -std::cos(t) + 8.0 * std::cos(2.0 * t), 9.0 * std::sin(3.0 * t)};
}

/// Frenet's frame closes after one round, and the trefoil is curved everywhere.
void addSection(Mesh& mesh, const KnotOptions& options, double t) {
    const glm::dvec3 tangent = glm::normalize(trefoilVelocity(t));
    const glm::dvec3 binormal = glm::normalize(glm::cross(tangent, trefoilAcceleration(t)));
    const glm::dvec3 normal = glm::cross(binormal, tangent);
    const double turn = 0.5 * options.twists * t;
    for (int s = 0; s < options.sides; ++s) {
        const double angle = 2.0 * glm::pi<double>() * s / options.sides;
        const double x = options.tube * std::cos(angle), y = options.tube * options.flattening * std::sin(angle);
        mesh.vertices.push_back(trefoil(t) + (x * std::cos(turn) - y * std::sin(turn)) * normal +
                                (x * std::sin(turn) + y * std::cos(turn)) * binormal);
    }
}

/// Centres the mesh and scales it so that its longest side is 2.
void fitBox(Mesh& mesh) {
    const Bounds bounds = boundsOf(mesh);
    const glm::dvec3 extent = bounds.max - bounds.min;
    const double scale = 2.0 / std::max({extent.x, extent.y, extent.z});
    for (glm::dvec3& v : mesh.vertices)
        v = scale * (v - 0.5 * (bounds.min + bounds.max));
}

int midpoint(Mesh& mesh, std::unordered_map<std::uint64_t, int>& known, int a, int b) {
    const std::uint64_t key = std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
    const auto [entry, isNew] = known.try_emplace(key, int(mesh.vertices.size()));
    if (isNew)
        mesh.vertices.push_back(glm::normalize(mesh.vertices[std::size_t(a)] + mesh.vertices[std::size_t(b)]));
    return entry->second;
}

Mesh icosahedron() {
    const double g = glm::golden_ratio<double>();
    Mesh mesh{{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
               {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}},
              {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
               {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};
    for (glm::dvec3& v : mesh.vertices)
        v = glm::normalize(v);
    return mesh;
}

} // namespace

Mesh generateKnot(const KnotOptions& options) {
    Mesh mesh;
    for (int i = 0; i < options.segments; ++i)
        addSection(mesh, options, 2.0 * glm::pi<double>() * i / options.segments);
    const int seam = options.twists * options.sides / 2;  // the section comes back turned by this many sides
    for (int i = 0; i < options.segments; ++i)
        for (int s = 0; s < options.sides; ++s) {
            const bool last = i + 1 == options.segments;
            const auto vertex = [&](int section, int side) {
                const int shifted = last && section != i ? side + seam : side;
                return section % options.segments * options.sides + shifted % options.sides;
            };
            const int a = vertex(i, s), b = vertex(i + 1, s), c = vertex(i + 1, s + 1), d = vertex(i, s + 1);
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
        }
    fitBox(mesh);
    return mesh;
}

Mesh generateIcosphere(int levels) {
    Mesh mesh = icosahedron();
    for (int level = 0; level < levels; ++level) {
        std::unordered_map<std::uint64_t, int> known;
        std::vector<glm::ivec3> finer;
        for (const glm::ivec3& t : std::vector<glm::ivec3>(mesh.triangles)) {
            const int xy = midpoint(mesh, known, t.x, t.y), yz = midpoint(mesh, known, t.y, t.z),
                      zx = midpoint(mesh, known, t.z, t.x);
            finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

} // namespace eikonal

// What keeps a mesh from enclosing a volume, and what can be done about it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <fmt/format.h>

#include "common/error.h"
#include "common/mesh.h"

namespace eikonal {
namespace {

/// Triangles at one edge; `balance` counts those that run along it from the lower index minus those against.
struct EdgeUse {
    int triangles = 0;
    int balance = 0;
};
using EdgeMap = std::unordered_map<std::uint64_t, EdgeUse>;

std::uint64_t edgeKey(int a, int b) {
    return std::uint64_t(std::uint32_t(std::min(a, b))) << 32 | std::uint32_t(std::max(a, b));
}

EdgeMap edgesOf(const Mesh& mesh) {
    EdgeMap edges;
    edges.reserve(mesh.triangles.size() * 2);
    for (const glm::ivec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const int from = t[i], to = t[(i + 1) % 3];
            EdgeUse& use = edges[edgeKey(from, to)];
            ++use.triangles;
            use.balance += from < to ? 1 : -1;
        }
    return edges;
}

/// Where two triangles run along an edge in the same direction, one of them is inside out.
bool isInconsistent(const EdgeUse& use) { return use.triangles == 2 && use.balance != 0; }

/// Edges that no other triangle runs against, as successors by vertex. They form closed chains: the boundary of a chain
/// of triangles has no boundary itself.
using Successors = std::unordered_map<int, std::vector<int>>;

Successors boundaryOf(const EdgeMap& edges) {
    Successors next;
    for (const auto& [key, use] : edges) {
        const int low = int(key >> 32), high = int(key & 0xffffffffu);
        for (int i = 0; i < std::abs(use.balance); ++i)
            use.balance > 0 ? next[low].push_back(high) : next[high].push_back(low);
    }
    for (auto& [vertex, list] : next)
        std::sort(list.begin(), list.end());
    return next;
}

/// Walks the boundary; a chain that meets itself at a vertex is cut into loops there.
std::vector<std::vector<int>> loopsOf(const EdgeMap& edges) {
    Successors next = boundaryOf(edges);
    std::vector<int> starts;
    for (const auto& [vertex, list] : next)
        starts.push_back(vertex);
    std::sort(starts.begin(), starts.end());  // the same loops in the same order on every run
    std::vector<std::vector<int>> loops;
    for (const int start : starts) {
        std::vector<int> path{start};
        std::unordered_map<int, std::size_t> onPath{{start, 0}};
        while (!next[path.back()].empty()) {
            std::vector<int>& choices = next[path.back()];
            const int to = choices.back();
            choices.pop_back();
            if (const auto met = onPath.find(to); met != onPath.end()) {
                const std::size_t first = met->second;
                loops.emplace_back(path.begin() + std::ptrdiff_t(first), path.end());
                for (std::size_t i = first + 1; i < path.size(); ++i)
                    onPath.erase(path[i]);
                path.resize(first + 1);
            } else {
                onPath[to] = path.size();
                path.push_back(to);
            }
        }
    }
    return loops;
}

double triangleArea(const Mesh& mesh, const glm::ivec3& t) {
    const glm::dvec3& a = mesh.vertices[std::size_t(t.x)];
    return 0.5 * glm::length(glm::cross(mesh.vertices[std::size_t(t.y)] - a, mesh.vertices[std::size_t(t.z)] - a));
}

/// Adds a fan around the loop's centroid; returns its area.
double capLoop(Mesh& mesh, const std::vector<int>& loop) {
    if (loop.size() < 3)
        return 0.0;
    glm::dvec3 centre(0.0);
    double perimeter = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec3& a = mesh.vertices[std::size_t(loop[i])];
        const glm::dvec3& b = mesh.vertices[std::size_t(loop[(i + 1) % loop.size()])];
        centre += glm::length(b - a) * 0.5 * (a + b);
        perimeter += glm::length(b - a);
    }
    const int hub = int(mesh.vertices.size());
    mesh.vertices.push_back(perimeter > 0.0 ? centre / perimeter : mesh.vertices[std::size_t(loop[0])]);
    double area = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        mesh.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], hub});
        area += triangleArea(mesh, mesh.triangles.back());
    }
    return area;
}

std::size_t countOpen(const EdgeMap& edges) {
    return std::size_t(std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second.balance != 0; }));
}

bool runsAlong(const glm::ivec3& t, int from, int to) {
    return (t.x == from && t.y == to) || (t.y == from && t.z == to) || (t.z == from && t.x == to);
}

/// Spreads the orientation of one triangle over its piece, across edges of two triangles.
class Orientation {
public:
    explicit Orientation(Mesh& mesh) : mesh_(mesh), done_(mesh.triangles.size(), 0) {
        for (int i = 0; i < int(mesh.triangles.size()); ++i)
            for (int e = 0; e < 3; ++e)
                sharing_[edgeKey(mesh.triangles[std::size_t(i)][e], mesh.triangles[std::size_t(i)][(e + 1) % 3])].push_back(i);
    }

    void spreadFrom(int seed) {
        std::vector<int> open;
        if (!done_[std::size_t(seed)])
            open.push_back(seed);
        done_[std::size_t(seed)] = 1;
        while (!open.empty()) {
            const glm::ivec3 t = mesh_.triangles[std::size_t(open.back())];
            open.pop_back();
            for (int e = 0; e < 3; ++e)
                spreadAcross(t[e], t[(e + 1) % 3], open);
        }
    }

    std::size_t turned() const { return turned_; }

private:
    void spreadAcross(int from, int to, std::vector<int>& open) {
        const std::vector<int>& sharing = sharing_[edgeKey(from, to)];
        for (const int other : sharing) {
            if (sharing.size() != 2 || done_[std::size_t(other)])
                continue;
            glm::ivec3& t = mesh_.triangles[std::size_t(other)];
            if (runsAlong(t, from, to)) {
                std::swap(t.y, t.z);
                ++turned_;
            }
            done_[std::size_t(other)] = 1;
            open.push_back(other);
        }
    }

    Mesh& mesh_;
    std::vector<char> done_;
    std::unordered_map<std::uint64_t, std::vector<int>> sharing_;
    std::size_t turned_ = 0;
};

/// Gives neighbours the same orientation, starting from the first triangle of each piece. Returns how many were turned.
std::size_t orientTriangles(Mesh& mesh) {
    Orientation orientation(mesh);
    for (int seed = 0; seed < int(mesh.triangles.size()); ++seed)
        orientation.spreadFrom(seed);
    return orientation.turned();
}

MeshReport inspect(const Mesh& mesh, const EdgeMap& edges, std::size_t loops) {
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.triangles = mesh.triangles.size();
    report.openEdges = report.openEdgesLeft = countOpen(edges);
    report.boundaryLoops = loops;
    report.nonManifoldEdges =
        std::size_t(std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second.triangles > 2; }));
    if (report.nonManifoldEdges > 0)
        report.messages.push_back(fmt::format("{} edges with more than two triangles", report.nonManifoldEdges));
    return report;
}

void turnOutwards(Mesh& mesh, MeshReport& report) {
    if (meshVolume(mesh) >= 0.0)
        return;
    for (glm::ivec3& t : mesh.triangles)
        std::swap(t.y, t.z);
    report.messages.push_back("the triangles face inwards: all turned");
}

} // namespace

MeshReport inspectMesh(const Mesh& mesh) {
    const EdgeMap edges = edgesOf(mesh);
    return inspect(mesh, edges, loopsOf(edges).size());
}

MeshReport closeHoles(Mesh& mesh) {
    EdgeMap edges = edgesOf(mesh);
    std::size_t turned = 0;
    if (std::any_of(edges.begin(), edges.end(), [](const auto& e) { return isInconsistent(e.second); })) {
        turned = orientTriangles(mesh);
        edges = edgesOf(mesh);
    }
    const std::vector<std::vector<int>> loops = loopsOf(edges);
    MeshReport report = inspect(mesh, edges, loops.size());
    if (turned > 0)
        report.messages.push_back(fmt::format("{} triangles faced against their neighbours: turned", turned));
    double area = 0.0, capArea = 0.0;
    for (const glm::ivec3& t : mesh.triangles)
        area += triangleArea(mesh, t);
    for (const std::vector<int>& loop : loops)
        capArea += capLoop(mesh, loop);
    report.loopsCapped = loops.size();
    report.openEdgesLeft = loops.empty() ? report.openEdges : countOpen(edgesOf(mesh));
    if (!loops.empty())
        report.messages.push_back(fmt::format("{} open edges around {} hole{}: closed with flat fans, {:.1f} % of the surface",
                                              report.openEdges, loops.size(), loops.size() == 1 ? "" : "s",
                                              100.0 * capArea / (area + capArea)));
    turnOutwards(mesh, report);
    if (!report.closed())
        report.messages.push_back(fmt::format("{} open edges could not be closed", report.openEdgesLeft));
    return report;
}

SolidMesh loadSolidMesh(const std::filesystem::path& path) {
    SolidMesh result{loadMesh(path), {}};
    result.report = closeHoles(result.mesh);
    const Bounds bounds = boundsOf(result.mesh);
    const double size = glm::length(bounds.max - bounds.min);
    // Far below any solid that voxels could show; rounding of a flat sheet's volume stays below.
    if (!result.report.closed() || std::abs(meshVolume(result.mesh)) <= 1e-9 * size * size * size)
        throw badInput(fmt::format("{}: expected a mesh that encloses a volume, found {} triangles around none{}",
                                   path.string(), result.report.triangles,
                                   result.report.openEdges > 0 ? ", with an open border" : ""));
    return result;
}

} // namespace eikonal

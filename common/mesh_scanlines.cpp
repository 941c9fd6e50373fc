#include "common/mesh_scanlines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal {
namespace {

/// Twice the signed area of (a, b, p), with the same rounding whichever triangle asks: the lower index comes first.
double edgeFunction(const std::array<glm::dvec2, 3>& corners, const glm::ivec3& ids, int from, int to, const glm::dvec2& p) {
    const bool swapped = ids[from] > ids[to];
    const glm::dvec2& a = corners[std::size_t(swapped ? to : from)];
    const glm::dvec2& b = corners[std::size_t(swapped ? from : to)];
    const double area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return swapped ? -area : area;
}

/// A point on an edge belongs to the triangle on one side of it: that on the left of edges going down, or going right.
bool ownsEdge(const glm::dvec2& from, const glm::dvec2& to) {
    return to.y < from.y || (to.y == from.y && to.x > from.x);
}

struct Projected {
    std::array<glm::dvec2, 3> corners;
    std::array<double, 3> depth{};
};

Projected project(const Mesh& mesh, const glm::ivec3& t, int axis) {
    Projected result;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& v = mesh.vertices[std::size_t(t[i])];
        result.corners[std::size_t(i)] = {v[(axis + 1) % 3], v[(axis + 2) % 3]};
        result.depth[std::size_t(i)] = v[axis];
    }
    return result;
}

/// True where the line through `p` crosses the triangle; `sign` is the triangle's orientation in the projection.
bool covers(const Projected& t, const glm::ivec3& ids, double sign, const glm::dvec2& p, glm::dvec3& weights) {
    for (int i = 0; i < 3; ++i) {
        const int from = (i + 1) % 3, to = (i + 2) % 3;
        weights[i] = sign * edgeFunction(t.corners, ids, from, to, p);
        if (weights[i] < 0.0)
            return false;
        const glm::dvec2& a = t.corners[std::size_t(sign > 0.0 ? from : to)];
        const glm::dvec2& b = t.corners[std::size_t(sign > 0.0 ? to : from)];
        if (weights[i] == 0.0 && !ownsEdge(a, b))
            return false;
    }
    return weights.x + weights.y + weights.z > 0.0;
}

int clampedIndex(double position, int count) { return int(std::clamp(position, 0.0, double(count))); }

void scanTriangle(const Mesh& mesh, const ScanRaster& raster, int index, std::vector<std::vector<Crossing>>& lines) {
    const glm::ivec3& ids = mesh.triangles[std::size_t(index)];
    const Projected t = project(mesh, ids, raster.axis);
    const glm::dvec2 e1 = t.corners[1] - t.corners[0], e2 = t.corners[2] - t.corners[0];
    const double area = e1.x * e2.y - e1.y * e2.x;
    if (area == 0.0)
        return;
    const glm::dvec2 low = (glm::min(glm::min(t.corners[0], t.corners[1]), t.corners[2]) - raster.first) / raster.spacing;
    const glm::dvec2 high = (glm::max(glm::max(t.corners[0], t.corners[1]), t.corners[2]) - raster.first) / raster.spacing;
    const double sign = area > 0.0 ? 1.0 : -1.0;
    for (int v = clampedIndex(std::floor(low.y), raster.count.y); v < clampedIndex(high.y + 2.0, raster.count.y); ++v)
        for (int u = clampedIndex(std::floor(low.x), raster.count.x); u < clampedIndex(high.x + 2.0, raster.count.x); ++u) {
            glm::dvec3 w(0.0);
            if (!covers(t, ids, sign, raster.first + raster.spacing * glm::dvec2(u, v), w))
                continue;
            const double at = (w.x * t.depth[0] + w.y * t.depth[1] + w.z * t.depth[2]) / (w.x + w.y + w.z);
            // A triangle that turns left in the projection faces along the axis: the line leaves the solid there.
            lines[std::size_t(v) * std::size_t(raster.count.x) + std::size_t(u)].push_back({at, area > 0.0 ? -1 : 1, index});
        }
}

} // namespace

std::vector<std::vector<Crossing>> scanMesh(const Mesh& mesh, const ScanRaster& raster) {
    std::vector<std::vector<Crossing>> lines(std::size_t(raster.count.x) * std::size_t(raster.count.y));
    for (int i = 0; i < int(mesh.triangles.size()); ++i)
        scanTriangle(mesh, raster, i, lines);
    for (auto& line : lines)
        std::sort(line.begin(), line.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
    return lines;
}

} // namespace eikonal

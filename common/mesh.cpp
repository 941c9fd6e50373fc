#include "common/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/mesh_scanlines.h"
#include "common/output_file.h"

namespace eikonal {
namespace {

/// Walls are looked for along this many lines across the mesh's longest side.
constexpr int kWallLines = 192;

glm::dvec3 unitNormal(const Mesh& mesh, int triangle) {
    const glm::ivec3& t = mesh.triangles[std::size_t(triangle)];
    const glm::dvec3& a = mesh.vertices[std::size_t(t.x)];
    const glm::dvec3 n = glm::cross(mesh.vertices[std::size_t(t.y)] - a, mesh.vertices[std::size_t(t.z)] - a);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : glm::dvec3(0.0);
}

struct WallSample {
    double thickness = 0.0;
    double area = 0.0;
};

/// Between entering and leaving the solid on nearly opposite faces there is a wall; wedges and rims are none.
void addWall(const Mesh& mesh, int axis, const Crossing& enter, const Crossing& leave, std::vector<WallSample>& samples) {
    const glm::dvec3 in = unitNormal(mesh, enter.triangle), out = unitNormal(mesh, leave.triangle);
    const double slant = std::abs(in[axis]);
    const bool seenBest = slant >= 0.577;  // every surface faces one of the axes at least so much
    if (seenBest && glm::dot(in, out) < -0.7)
        samples.push_back({(leave.at - enter.at) * slant, 1.0 / slant});
}

void addWalls(const Mesh& mesh, const ScanRaster& raster, std::vector<WallSample>& samples) {
    for (const std::vector<Crossing>& line : scanMesh(mesh, raster)) {
        int winding = 0;
        const Crossing* enter = nullptr;
        for (const Crossing& crossing : line) {
            if (winding == 0)
                enter = &crossing;
            winding += crossing.winding;
            if (winding == 0 && enter)
                addWall(mesh, raster.axis, *enter, crossing, samples);
        }
    }
}

double percentile(const std::vector<WallSample>& sorted, double fraction) {
    double total = 0.0, sum = 0.0;
    for (const WallSample& s : sorted)
        total += s.area;
    for (const WallSample& s : sorted) {
        sum += s.area;
        if (sum >= fraction * total)
            return s.thickness;
    }
    return 0.0;
}

} // namespace

Bounds boundsOf(const Mesh& mesh) {
    if (mesh.vertices.empty())
        return {};
    Bounds bounds{mesh.vertices[0], mesh.vertices[0]};
    for (const glm::dvec3& v : mesh.vertices)
        bounds = {glm::min(bounds.min, v), glm::max(bounds.max, v)};
    return bounds;
}

double meshVolume(const Mesh& mesh) {
    const Bounds bounds = boundsOf(mesh);
    const glm::dvec3 centre = 0.5 * (bounds.min + bounds.max);  // keeps the terms small
    double sum = 0.0;
    for (const glm::ivec3& t : mesh.triangles)
        sum += glm::dot(mesh.vertices[std::size_t(t.x)] - centre, glm::cross(mesh.vertices[std::size_t(t.y)] - centre,
                                                                             mesh.vertices[std::size_t(t.z)] - centre));
    return sum / 6.0;
}

WallThickness wallThickness(const Mesh& mesh) {
    const Bounds bounds = boundsOf(mesh);
    const glm::dvec3 extent = bounds.max - bounds.min;
    const double spacing = std::max({extent.x, extent.y, extent.z}) / kWallLines;
    std::vector<WallSample> samples;
    for (int axis = 0; axis < 3 && spacing > 0.0; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        // Off the lattice of round coordinates, where lines would run inside of faces.
        const glm::dvec2 first = glm::dvec2(bounds.min[u], bounds.min[v]) + 0.4142 * spacing;
        const glm::ivec2 count(int(std::ceil(extent[u] / spacing)), int(std::ceil(extent[v] / spacing)));
        addWalls(mesh, {axis, first, spacing, count}, samples);
    }
    std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.thickness < b.thickness; });
    return {percentile(samples, 0.01), percentile(samples, 0.5)};
}

int WallThickness::resolutionForTwoVoxels(double longestSide) const {
    if (thinnest <= 0.0)
        return std::numeric_limits<int>::max();
    return int(std::min(std::ceil(2.0 * longestSide / thinnest), double(std::numeric_limits<int>::max())));
}

void writeObj(const std::filesystem::path& path, const Mesh& mesh) {
    fmt::memory_buffer text;
    for (const glm::dvec3& v : mesh.vertices)
        fmt::format_to(std::back_inserter(text), "v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
    for (const glm::ivec3& t : mesh.triangles)
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
    writeFile(path, std::string_view(text.data(), text.size()));
}

} // namespace eikonal

#include "lightsim/tubes/power_of_rays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "common/device_frame.h"
#include "common/physics.h"

namespace eikonal::bake {

namespace {

// Places along each edge of a sub-cell at which it is seen whether light meets the domain; each stands for as much of the power.
constexpr int kAcross = 16;

class Rim {
public:
    Rim(const LaunchMesh& mesh, const LaunchGrids& grids, const Lattice& domain)
        : mesh_(mesh), grids_(grids), min_(deviceFromWorld(domain, domain.min)),
          max_(deviceFromWorld(domain, domain.min + domain.extent())), isWithin_(mesh.vertices.size()) {
        for (std::size_t i = 0; i < isWithin_.size(); ++i) {
            const LaunchFrame& frame = frameOf(std::uint32_t(i));
            isWithin_[i] = meets(frame, glm::dvec2(LaunchMesh::launchOf(mesh.vertices[i], frame)));
        }
    }

    bool isWithin(std::uint32_t vertex) const { return isWithin_[vertex] != 0; }

    /// Of the power of a sub-cell, by corner: (u0, v0), (u1, v0), (u0, v1), (u1, v1).
    std::array<double, 4> shares(const std::array<std::uint32_t, 4>& corners) const {
        const auto count = std::count_if(corners.begin(), corners.end(), [this](std::uint32_t v) { return isWithin(v); });
        std::array<double, 4> result{0.25, 0.25, 0.25, 0.25};
        if (count == 0 || count == 4) {
            return result;
        }
        const double within = shareWithin(corners);
        for (int i = 0; i < 4; ++i) {
            result[std::size_t(i)] = isWithin(corners[std::size_t(i)]) ? within / double(count) : (1.0 - within) / double(4 - count);
        }
        return result;
    }

private:
    const LaunchFrame& frameOf(std::uint32_t vertex) const { return grids_.frames[mesh_.vertices[vertex].frame]; }

    bool meets(const LaunchFrame& frame, const glm::dvec2& launch) const {
        const glm::dvec3 offset = glm::dvec3(frame.a) * launch.x + glm::dvec3(frame.b) * launch.y;
        const auto line = f64::launchLine(frame.isPoint != 0, frame.origin, frame.centre, frame.axis, offset);
        return f64::meetsDomain(line, f64::boxSpan(line.target, line.direction, min_, max_));
    }

    double shareWithin(const std::array<std::uint32_t, 4>& corners) const {
        const LaunchFrame& frame = frameOf(corners[0]);
        const glm::dvec2 low(LaunchMesh::launchOf(mesh_.vertices[corners[0]], frame));
        const glm::dvec2 high(LaunchMesh::launchOf(mesh_.vertices[corners[3]], frame));
        int count = 0;
        for (int j = 0; j < kAcross; ++j) {
            for (int i = 0; i < kAcross; ++i) {
                count += meets(frame, glm::mix(low, high, (glm::dvec2(i, j) + 0.5) / double(kAcross))) ? 1 : 0;
            }
        }
        return double(count) / (kAcross * kAcross);
    }

    const LaunchMesh& mesh_;
    const LaunchGrids& grids_;
    glm::dvec3 min_, max_;
    std::vector<std::uint8_t> isWithin_;  ///< vertices
};

/// What a vertex that is no ray has goes to its parents: to the one that is on its side of the rim, or halves.
void leaveToRays(const LaunchMesh& mesh, const Rim& rim, std::vector<glm::dvec4>& powers) {
    std::vector<std::uint32_t> byDepth(powers.size());
    std::iota(byDepth.begin(), byDepth.end(), 0u);
    std::stable_sort(byDepth.begin(), byDepth.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return mesh.vertices[a].depth > mesh.vertices[b].depth; });
    for (const std::uint32_t i : byDepth) {
        if (mesh.vertices[i].isRay) {
            continue;
        }
        const auto [first, second] = mesh.vertices[i].parents;
        const bool differ = rim.isWithin(first) != rim.isWithin(second);
        const double toFirst = !differ ? 0.5 : rim.isWithin(first) == rim.isWithin(i) ? 1.0 : 0.0;
        powers[first] += toFirst * powers[i];
        powers[second] += (1.0 - toFirst) * powers[i];
        powers[i] = glm::dvec4(0.0);
    }
}

} // namespace

std::vector<glm::dvec4> powerOfRays(const LaunchMesh& mesh, const LaunchGrids& grids, const Lattice& domain) {
    const Rim rim(mesh, grids, domain);
    std::vector<glm::dvec4> powers(mesh.vertices.size(), glm::dvec4(0.0));
    for (std::uint32_t index = 0; index < mesh.nodes.size(); ++index) {
        const MeshNode& node = mesh.nodes[index];
        if (!node.isLeaf()) {
            continue;
        }
        const glm::dvec4 strength(grids.frames[mesh.vertices[node.corners[0]].frame].strength, 0.0);
        mesh.forEachQuarter(index, [&](int quarter, const std::array<std::uint32_t, 4>& corners) {
            const std::array<double, 4> shares = rim.shares(corners);
            for (std::size_t i = 0; i < 4; ++i) {
                powers[corners[i]] += strength * (shares[i] * node.launchShare[quarter]);
            }
        });
    }
    leaveToRays(mesh, rim, powers);
    return powers;
}

} // namespace eikonal::bake

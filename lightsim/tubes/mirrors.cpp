#include "lightsim/tubes/mirrors.h"

#include <algorithm>
#include <numeric>

namespace eikonal::bake {

std::uint32_t packed(const Mirrors& mirrors) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        word |= mirrors[i] << (i * TUBE_MIRROR_BITS);
    }
    return word;
}

LightPath pathFromSource(const LaunchGrids& grids) {
    LightPath path{{}, std::vector<std::uint32_t>(grids.cellCount)};
    std::iota(path.cells.begin(), path.cells.end(), 0u);
    return path;
}

std::vector<PowerByCrossing> reflectedByRoot(const LaunchMesh& mesh, const LaunchGrids& grids,
                                             std::span<const TubeReflections> reflections, std::size_t rootCount) {
    std::vector<PowerByCrossing> shares(mesh.vertices.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {  // parents have lower numbers
        const MeshVertex& vertex = mesh.vertices[i];
        for (std::size_t k = 0; k < TUBE_CROSSINGS; ++k) {
            shares[i][k] = vertex.isRay ? double(reflections[i].shares[k])
                                        : 0.5 * (shares[vertex.parents[0]][k] + shares[vertex.parents[1]][k]);
        }
    }
    std::vector<PowerByCrossing> powers(rootCount, PowerByCrossing{});
    for (std::uint32_t index = 0; index < mesh.nodes.size(); ++index) {
        const MeshNode& node = mesh.nodes[index];
        if (!node.isLeaf()) {
            continue;
        }
        const glm::vec3& strength = grids.frames[mesh.vertices[node.corners[0]].frame].strength;
        mesh.forEachQuarterCorner(index, [&](int quarter, std::uint32_t vertex) {
            const double power = 0.25 * node.launchShare[quarter] * double(std::max({strength.x, strength.y, strength.z}));
            for (std::size_t k = 0; k < TUBE_CROSSINGS; ++k) {
                powers[node.root][k] += power * shares[vertex][k];
            }
        });
    }
    return powers;
}

void ReflectedLight::add(std::span<const std::uint32_t> cells, std::span<const PowerByCrossing> powers) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (std::size_t k = 0; k < TUBE_CROSSINGS; ++k) {
            if (powers[i][k] > 0.0) {
                power_[k] += powers[i][k];
                cells_[k].push_back(cells[i]);
            }
        }
    }
}

std::vector<LightPath> ReflectedLight::pathsBehind(const Mirrors& mirrors, double leastPower) const {
    std::vector<LightPath> paths;
    for (std::size_t k = 0; k < TUBE_CROSSINGS; ++k) {
        if (power_[k] > 0.0 && power_[k] >= leastPower) {
            paths.push_back({mirrors, cells_[k]});
            paths.back().mirrors.push_back(std::uint32_t(k));
            std::sort(paths.back().cells.begin(), paths.back().cells.end());
        }
    }
    return paths;
}

} // namespace eikonal::bake

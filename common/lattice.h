#pragma once
// The lattice of cubic voxels that every dense grid of a scene lives on.

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace eikonal {

/// Cubic voxels of edge `voxel` [scene units]; voxel (i, j, k) is centred at min + (i + 1/2, j + 1/2, k + 1/2) voxel.
struct Lattice {
    glm::dvec3 min{0.0};  ///< world position of the lower corner of the domain box [scene units]
    double voxel = 1.0;   ///< edge of a voxel [scene units]
    glm::ivec3 size{0};   ///< voxels along x, y, z

    glm::dvec3 max() const { return min + voxel * glm::dvec3(size); }
    glm::dvec3 extent() const { return voxel * glm::dvec3(size); }
    glm::dvec3 worldFromIndex(const glm::ivec3& index) const { return min + voxel * (glm::dvec3(index) + 0.5); }
    std::size_t count() const { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }
    bool operator==(const Lattice&) const = default;
};

/// Dense values over a lattice, x fastest, then y, then z. An empty grid means: the scene does not call for it.
template <class Value>
struct DenseGrid {
    glm::ivec3 size{0};
    std::vector<Value> values;

    DenseGrid() = default;
    DenseGrid(const glm::ivec3& gridSize, const Value& fill)
        : size(gridSize), values(std::size_t(gridSize.x) * std::size_t(gridSize.y) * std::size_t(gridSize.z), fill) {}

    bool empty() const { return values.empty(); }
    std::size_t offset(int i, int j, int k) const {
        return (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) + std::size_t(i);
    }
    Value& at(int i, int j, int k) { return values[offset(i, j, k)]; }
    const Value& at(int i, int j, int k) const { return values[offset(i, j, k)]; }
    Value& at(const glm::ivec3& v) { return at(v.x, v.y, v.z); }
    const Value& at(const glm::ivec3& v) const { return at(v.x, v.y, v.z); }
};

} // namespace eikonal

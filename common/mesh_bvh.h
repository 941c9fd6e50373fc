#pragma once
// Boxes around boxes around triangles: the nearest triangle without looking at all of them.

#include <vector>

#include <glm/glm.hpp>

#include "common/mesh.h"

namespace eikonal {

class MeshBvh {
public:
    /// Keeps copies of the corners; the mesh may go.
    explicit MeshBvh(const Mesh& mesh);

    /// Distance from p to the nearest triangle if below `bound`, else `bound`. `hint` takes the nearest triangle, and the
    /// one from a call for a point close by shortens the search; start with -1. Safe from several threads.
    double distance(const glm::dvec3& p, double bound, int& hint) const;

private:
    struct Triangle {
        glm::dvec3 a, b, c;
        double squaredDistance(const glm::dvec3& p) const;
    };
    /// Inner nodes have children at `first` and `first + 1`, leaves (count > 0) triangles from `first` on.
    struct Node {
        Bounds bounds;
        int first = 0;
        int count = 0;
    };

    void split(std::size_t node);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

} // namespace eikonal

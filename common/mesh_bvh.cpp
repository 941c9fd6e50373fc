#include "common/mesh_bvh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal {
namespace {

constexpr int kLeafTriangles = 2;
/// Halving 2^31 triangles takes 31 levels; each level leaves at most one box waiting.
constexpr std::size_t kStack = 64;

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

double squaredDistanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double length = squared(along);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return squared(p - a - t * along);
}

double squaredDistanceToBox(const glm::dvec3& p, const Bounds& box) {
    return squared(glm::max(glm::max(box.min - p, p - box.max), 0.0));
}

} // namespace

double MeshBvh::Triangle::squaredDistance(const glm::dvec3& p) const {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = squared(normal);
    const bool above = area > 0.0 && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 &&
                       glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
                       glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
    if (above) {
        const double height = glm::dot(p - a, normal);
        return height * height / area;
    }
    return std::min({squaredDistanceToSegment(p, a, b), squaredDistanceToSegment(p, b, c), squaredDistanceToSegment(p, c, a)});
}

MeshBvh::MeshBvh(const Mesh& mesh) {
    for (const glm::ivec3& t : mesh.triangles)
        triangles_.push_back({mesh.vertices[std::size_t(t.x)], mesh.vertices[std::size_t(t.y)], mesh.vertices[std::size_t(t.z)]});
    nodes_.reserve(triangles_.size() + 1);
    nodes_.push_back({{}, 0, int(triangles_.size())});
    for (std::size_t node = 0; node < nodes_.size(); ++node)
        split(node);
}

/// At the median along the longest side of the box around the triangles' centroids.
void MeshBvh::split(std::size_t node) {
    const auto begin = triangles_.begin() + nodes_[node].first, end = begin + nodes_[node].count;
    if (begin == end)
        return;
    const auto centroid = [](const Triangle& t) { return t.a + t.b + t.c; };
    Bounds bounds{begin->a, begin->a}, centres{centroid(*begin), centroid(*begin)};
    for (auto t = begin; t != end; ++t) {
        bounds.min = glm::min(bounds.min, glm::min(t->a, glm::min(t->b, t->c)));
        bounds.max = glm::max(bounds.max, glm::max(t->a, glm::max(t->b, t->c)));
        centres = {glm::min(centres.min, centroid(*t)), glm::max(centres.max, centroid(*t))};
    }
    nodes_[node].bounds = bounds;
    if (nodes_[node].count <= kLeafTriangles)
        return;
    const glm::dvec3 extent = centres.max - centres.min;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const int half = nodes_[node].count / 2, first = nodes_[node].first, count = nodes_[node].count;
    std::nth_element(begin, begin + half, end,
                     [&](const Triangle& s, const Triangle& t) { return centroid(s)[axis] < centroid(t)[axis]; });
    nodes_[node].first = int(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, count - half});
}

double MeshBvh::distance(const glm::dvec3& p, double bound, int& hint) const {
    struct Waiting {
        int node;
        double distance;
    };
    if (triangles_.empty())
        return bound;
    std::array<Waiting, kStack> stack;
    std::size_t depth = 0;
    double best = bound * bound;
    if (hint >= 0)
        best = std::min(best, triangles_[std::size_t(hint)].squaredDistance(p));
    stack[depth++] = {0, squaredDistanceToBox(p, nodes_[0].bounds)};
    while (depth > 0) {
        const Waiting next = stack[--depth];
        if (next.distance >= best)
            continue;
        const Node& node = nodes_[std::size_t(next.node)];
        for (int i = 0; i < node.count; ++i) {
            const double found = triangles_[std::size_t(node.first + i)].squaredDistance(p);
            if (found < best) {
                best = found;
                hint = node.first + i;
            }
        }
        if (node.count > 0)
            continue;
        Waiting near{node.first, squaredDistanceToBox(p, nodes_[std::size_t(node.first)].bounds)};
        Waiting far{node.first + 1, squaredDistanceToBox(p, nodes_[std::size_t(node.first + 1)].bounds)};
        if (far.distance < near.distance)
            std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
    return std::sqrt(best);
}

} // namespace eikonal

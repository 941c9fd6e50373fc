#pragma once
// The launch mesh: rectangles of launch coordinates, halved where the rays between them are not where their neighbours say,
// without gaps or overlaps between rectangles of different size.
//
// A node is a rectangle with 3 x 3 vertices: its corners, the middles of its sides, its centre. An edge belongs to the
// rectangles on both sides of it, and one measurement of the ray in its middle decides for both: where it is off, both are
// halved there. Where only one of them is halved (for its other sides' sake), the new vertices on the common edge are no
// rays of their own: they conform to the edge. The same holds sample by sample along the tracks, so that a node can be
// deposited whole at those steps at which nothing in it is off.

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/glm.hpp>

#include "shaders/shared/tube_blocks.h"

namespace eikonal::bake {

/// Bit k: sample k of the window (shaders/shared/tube_blocks.h).
using Samples = std::uint64_t;
inline constexpr Samples kAllSamples = ~Samples(0);
inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

struct MeshVertex {
    std::uint32_t frame;
    glm::uvec2 place;         ///< launch coordinate in units of kCellUnits a cell of the frame's grid
    std::uint32_t parents[2]; ///< that it lies halfway between; kNone: a corner of the grid
    std::uint32_t depth;      ///< generations of halving
    bool isRay = false;       ///< traced; otherwise always halfway between its parents
    bool isNew = false;       ///< its ray was not there in the window before
    std::uint32_t edge = kNone;  ///< whose middle it is
};

struct MeshEdge {
    std::uint32_t ends[2];
    std::uint32_t parent = kNone;
    std::uint32_t children[2] = {kNone, kNone};
    std::uint32_t middle = kNone;
    std::uint32_t beside[2] = {kNone, kNone};  ///< smallest nodes that it is a whole side of: at its lower, its higher coordinate
    bool isLive;           ///< its middle is a ray, and measured
    Samples strong = 0;    ///< the middle is off, with power that matters
    Samples weak = 0;      ///< the same, with less power
    Samples split = 0;     ///< strong, or one of its children is
};

struct MeshNode {
    std::uint32_t corners[4];  ///< (u0, v0), (u1, v0), (u1, v1), (u0, v1)
    std::uint32_t edges[4];    ///< v0, u1, v1, u0
    std::uint32_t centre = kNone;
    std::uint32_t children[2] = {kNone, kNone};
    std::uint32_t root;
    glm::dvec4 launchShare{0.0};  ///< power launched into its sub-cells, over the frame's strength
    Samples strong = 0, weak = 0; ///< of its centre
    Samples fine = 0;             ///< steps at which its children are deposited in its place

    bool isLeaf() const { return children[0] == kNone; }
};

class LaunchMesh {
public:
    static constexpr std::uint32_t kCellUnits = 1u << 12;  ///< a cell can be halved twelve times along each side

    /// Room for a mesh of so many vertices, each of which is the middle of an edge or of a node.
    void reserve(std::uint32_t vertexCount);
    /// Adds cell number `cell` of a frame's grid as a root node; returns its number.
    std::uint32_t addCell(std::uint32_t frameIndex, const LaunchFrame& frame, std::uint32_t cell);

    /// A window begins: what was measured in the one before is forgotten.
    void beginWindow();
    /// The vertex is traced from now on.
    void makeRay(std::uint32_t vertex);
    /// Halves every leaf that has something strong, once; returns the first of the new nodes, which are last. What has been
    /// measured since the last time: edges, and nodes, all new ones among them. Edges that have become live are appended to
    /// `liveEdges`. With `capacity` vertices no more leaves are halved.
    std::uint32_t refine(std::uint32_t capacity, std::span<const std::uint32_t> measuredEdges,
                         std::span<const std::uint32_t> measuredNodes, std::vector<std::uint32_t>& liveEdges);
    std::uint32_t refusedHalvings() const { return refused_; }
    /// From the measurements of the window: where edges are split and nodes are fine.
    void settle();

    /// Samples at which a vertex is where its own ray is.
    Samples liveSamples(std::uint32_t vertex) const;
    /// Corners, middles of sides and centre, row by row.
    void verticesOf(std::uint32_t node, std::uint32_t (&out)[9]) const;
    /// Calls visit(quarter, corners) for each of a node's four sub-cells: (u0, v0), (u1, v0), (u0, v1), (u1, v1).
    template <class Visit>
    void forEachQuarter(std::uint32_t node, const Visit& visit) const {
        std::uint32_t own[9];
        verticesOf(node, own);
        for (int quarter = 0; quarter < 4; ++quarter) {
            const int low = quarter % 2 + 3 * (quarter / 2);
            visit(quarter, std::array<std::uint32_t, 4>{own[low], own[low + 1], own[low + 3], own[low + 4]});
        }
    }
    /// Calls visit(quarter, vertex) for the corners of these.
    template <class Visit>
    void forEachQuarterCorner(std::uint32_t node, const Visit& visit) const {
        forEachQuarter(node, [&](int quarter, const std::array<std::uint32_t, 4>& corners) {
            for (const std::uint32_t corner : corners) {
                visit(quarter, corner);
            }
        });
    }
    /// Launch coordinates in [-1, 1]².
    static glm::vec2 launchOf(const MeshVertex& vertex, const LaunchFrame& frame);
    /// Steps at which a leaf is not resolved, for want of power.
    Samples weakSteps(const MeshNode& node) const;

    std::vector<MeshVertex> vertices;
    std::vector<MeshEdge> edges;
    std::vector<MeshNode> nodes;

private:
    bool isFirstWindow_ = true;
    std::uint32_t refused_ = 0;

    struct PlaceHash {
        std::size_t operator()(const glm::uvec3& key) const;
    };

    /// The corner of a cell, the side of one: those of cells beside it where they have been added.
    std::uint32_t cornerAt(std::uint32_t frame, const glm::uvec2& place);
    std::uint32_t sideBetween(std::uint32_t a, std::uint32_t b);
    std::uint32_t addVertex(const glm::uvec2& place, std::uint32_t first, std::uint32_t second);
    std::uint32_t addEdge(std::uint32_t a, std::uint32_t b, std::uint32_t middle, std::uint32_t parent, bool isLive);
    std::uint32_t addMiddle(std::uint32_t a, std::uint32_t b);
    std::uint32_t addNode(const std::uint32_t (&corners)[4], const std::uint32_t (&sides)[4], std::uint32_t root,
                          bool halvedAlongU);
    void halveEdge(std::uint32_t edge);
    void wake(std::uint32_t edge, std::vector<std::uint32_t>& liveEdges);
    bool wantsHalving(const MeshNode& node, bool& alongU) const;
    /// Leaves that what was measured may want to be halved, in their order.
    std::vector<std::uint32_t> leavesConcerned(std::span<const std::uint32_t> edges, std::span<const std::uint32_t> nodes) const;
    /// A node is beside its sides from now on, in place of the one that it is a half of.
    void standBeside(std::uint32_t node, const std::uint32_t (&sides)[4]);
    void halve(std::uint32_t node, bool alongU);
    bool canHalve(std::uint32_t edge) const;

    std::unordered_map<glm::uvec3, std::uint32_t, PlaceHash> cornerByPlace_;
    std::unordered_map<std::uint64_t, std::uint32_t> sideByEnds_;
};

/// Steps that have a sample at either end.
inline Samples stepsAt(Samples samples) { return samples | (samples >> 1); }

} // namespace eikonal::bake

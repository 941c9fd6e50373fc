#include "lightsim/tubes/launch_mesh.h"

#include <algorithm>
#include <utility>

namespace eikonal::bake {

namespace {

/// Whether a node lies at the higher coordinate of one of its sides: v0, u1, v1, u0.
constexpr bool isHigherThanSide(int side) { return side == 0 || side == 3; }

} // namespace

std::size_t LaunchMesh::PlaceHash::operator()(const glm::uvec3& key) const {
    std::uint64_t hash = key.x * 0x9E3779B97F4A7C15ull;
    hash = (hash ^ (hash >> 29) ^ key.y) * 0xBF58476D1CE4E5B9ull;
    hash = (hash ^ (hash >> 32) ^ key.z) * 0x94D049BB133111EBull;
    return std::size_t(hash ^ (hash >> 31));
}

void LaunchMesh::reserve(std::uint32_t vertexCount) {
    vertices.reserve(vertexCount);
    edges.reserve(vertexCount / 2);
    nodes.reserve(vertexCount / 2);
}

std::uint32_t LaunchMesh::cornerAt(std::uint32_t frame, const glm::uvec2& place) {
    const auto [entry, isAdded] = cornerByPlace_.try_emplace({frame, place.x, place.y}, std::uint32_t(vertices.size()));
    if (isAdded) {
        vertices.push_back({frame, place, {kNone, kNone}, 0});
    }
    return entry->second;
}

std::uint32_t LaunchMesh::sideBetween(std::uint32_t a, std::uint32_t b) {
    const auto [entry, isAdded] = sideByEnds_.try_emplace(std::uint64_t(a) << 32 | b, std::uint32_t(edges.size()));
    if (isAdded) {
        addEdge(a, b, addMiddle(a, b), kNone, true);
    }
    return entry->second;
}

std::uint32_t LaunchMesh::addVertex(const glm::uvec2& place, std::uint32_t first, std::uint32_t second) {
    const std::uint32_t depth = 1 + std::max(vertices[first].depth, vertices[second].depth);
    vertices.push_back({vertices[first].frame, place, {first, second}, depth});
    return std::uint32_t(vertices.size() - 1);
}

std::uint32_t LaunchMesh::addMiddle(std::uint32_t a, std::uint32_t b) {
    return addVertex((vertices[a].place + vertices[b].place) / 2u, a, b);
}

std::uint32_t LaunchMesh::addEdge(std::uint32_t a, std::uint32_t b, std::uint32_t middle, std::uint32_t parent, bool isLive) {
    const std::uint32_t index = std::uint32_t(edges.size());
    vertices[middle].edge = index;
    edges.push_back({{a, b}, parent, {kNone, kNone}, middle, {kNone, kNone}, isLive});
    return index;
}

void LaunchMesh::standBeside(std::uint32_t node, const std::uint32_t (&sides)[4]) {
    for (int side = 0; side < 4; ++side) {
        edges[sides[side]].beside[isHigherThanSide(side)] = node;
    }
}

std::uint32_t LaunchMesh::addNode(const std::uint32_t (&corners)[4], const std::uint32_t (&sides)[4], std::uint32_t root,
                                  bool halvedAlongU) {
    MeshNode node{};
    std::copy(std::begin(corners), std::end(corners), node.corners);
    std::copy(std::begin(sides), std::end(sides), node.edges);
    node.root = root;
    const auto middle = [&](int side) { return edges[sides[side]].middle; };
    const glm::uvec2 place(vertices[middle(0)].place.x, vertices[middle(1)].place.y);
    // in the sub-cells of the node that it came from, its centre lies between the sides that this one was cut to
    node.centre = halvedAlongU ? addVertex(place, middle(3), middle(1)) : addVertex(place, middle(0), middle(2));
    const std::uint32_t index = std::uint32_t(nodes.size());
    nodes.push_back(node);
    standBeside(index, sides);
    return index;
}

std::uint32_t LaunchMesh::addCell(std::uint32_t frameIndex, const LaunchFrame& frame, std::uint32_t cell) {
    const glm::uvec2 low = glm::uvec2(cell % frame.cellsU, cell / frame.cellsU) * kCellUnits;
    const glm::uvec2 high = low + kCellUnits;
    const std::uint32_t a = cornerAt(frameIndex, low);
    const std::uint32_t b = cornerAt(frameIndex, {high.x, low.y});
    const std::uint32_t c = cornerAt(frameIndex, high);
    const std::uint32_t d = cornerAt(frameIndex, {low.x, high.y});
    const std::uint32_t root = std::uint32_t(nodes.size());
    return addNode({a, b, c, d}, {sideBetween(a, b), sideBetween(b, c), sideBetween(d, c), sideBetween(a, d)}, root, true);
}

void LaunchMesh::beginWindow() {
    for (MeshVertex& vertex : vertices) {
        vertex.isNew = false;
    }
    for (MeshEdge& edge : edges) {
        edge.strong = edge.weak = edge.split = 0;
    }
    for (MeshNode& node : nodes) {
        node.strong = node.weak = node.fine = 0;
    }
    isFirstWindow_ = false;
}

void LaunchMesh::makeRay(std::uint32_t vertex) { vertices[vertex].isRay = vertices[vertex].isNew = true; }

bool LaunchMesh::canHalve(std::uint32_t edge) const {
    const glm::uvec2 extent = vertices[edges[edge].ends[1]].place - vertices[edges[edge].ends[0]].place;
    return std::max(extent.x, extent.y) >= 4;  // its halves need a middle too
}

void LaunchMesh::halveEdge(std::uint32_t index) {
    if (edges[index].children[0] != kNone) {
        return;
    }
    const auto [a, b] = std::pair(edges[index].ends[0], edges[index].ends[1]);
    const std::uint32_t middle = edges[index].middle;
    const bool isLive = edges[index].isLive && edges[index].strong != 0;
    const std::uint32_t first = addEdge(a, middle, addMiddle(a, middle), index, isLive);
    const std::uint32_t second = addEdge(middle, b, addMiddle(middle, b), index, isLive);
    edges[index].children[0] = first;
    edges[index].children[1] = second;
}

/// An edge that was halved for a neighbour's sake, and turns out to be off itself: its halves are measured from now on.
void LaunchMesh::wake(std::uint32_t index, std::vector<std::uint32_t>& liveEdges) {
    for (const std::uint32_t child : edges[index].children) {
        if (child != kNone && !edges[child].isLive) {
            edges[child].isLive = true;
            liveEdges.push_back(child);
        }
    }
}

/// Across a side that is off, the longer one if both are; the same for the sake of the centre.
bool LaunchMesh::wantsHalving(const MeshNode& node, bool& alongU) const {
    const auto isStrong = [&](int a, int b) { return (edges[node.edges[a]].strong | edges[node.edges[b]].strong) != 0; };
    const bool canU = canHalve(node.edges[0]);
    const bool canV = canHalve(node.edges[1]);
    const bool wantsU = canU && isStrong(0, 2);
    const bool wantsV = canV && isStrong(1, 3);
    const glm::uvec2 extent = vertices[node.corners[2]].place - vertices[node.corners[0]].place;
    alongU = wantsU != wantsV ? wantsU : (canU && (!canV || extent.x >= extent.y));
    return wantsU || wantsV || (node.strong != 0 && (canU || canV));
}

void LaunchMesh::halve(std::uint32_t index, bool alongU) {
    const MeshNode node = nodes[index];
    const auto& c = node.corners;
    const auto& e = node.edges;
    const int cut[2] = {alongU ? 0 : 3, alongU ? 2 : 1};  // sides that are halved, the first from corner 0
    halveEdge(e[cut[0]]);
    halveEdge(e[cut[1]]);
    const std::uint32_t m = edges[e[cut[0]]].middle, n = edges[e[cut[1]]].middle;
    const std::uint32_t across = addEdge(m, n, node.centre, kNone, true);
    const std::uint32_t *low = edges[e[cut[0]]].children, *high = edges[e[cut[1]]].children;
    const std::uint32_t parts[4] = {low[0], low[1], high[0], high[1]};
    const std::uint32_t first = alongU ? addNode({c[0], m, n, c[3]}, {parts[0], across, parts[2], e[3]}, node.root, true)
                                       : addNode({c[0], c[1], n, m}, {e[0], parts[2], across, parts[0]}, node.root, false);
    const std::uint32_t second = alongU ? addNode({m, c[1], c[2], n}, {parts[1], e[1], parts[3], across}, node.root, true)
                                        : addNode({m, n, c[2], c[3]}, {across, parts[3], e[2], parts[1]}, node.root, false);
    nodes[index].children[0] = first;
    nodes[index].children[1] = second;
}

std::vector<std::uint32_t> LaunchMesh::leavesConcerned(std::span<const std::uint32_t> measuredEdges,
                                                       std::span<const std::uint32_t> measuredNodes) const {
    std::vector<std::uint32_t> concerned(measuredNodes.begin(), measuredNodes.end());
    for (const std::uint32_t edge : measuredEdges) {
        if (edges[edge].strong != 0) {
            concerned.insert(concerned.end(), std::begin(edges[edge].beside), std::end(edges[edge].beside));
        }
    }
    std::erase_if(concerned, [&](std::uint32_t node) { return node == kNone || !nodes[node].isLeaf(); });
    std::sort(concerned.begin(), concerned.end());
    concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
    return concerned;
}

std::uint32_t LaunchMesh::refine(std::uint32_t capacity, std::span<const std::uint32_t> measuredEdges,
                                 std::span<const std::uint32_t> measuredNodes, std::vector<std::uint32_t>& liveEdges) {
    constexpr std::uint32_t kMostNewVertices = 9;  // of a halving
    const std::uint32_t firstEdge = std::uint32_t(edges.size());
    const std::uint32_t firstNode = std::uint32_t(nodes.size());
    for (const std::uint32_t edge : measuredEdges) {
        if (edges[edge].strong != 0) {
            wake(edge, liveEdges);
        }
    }
    for (const std::uint32_t node : leavesConcerned(measuredEdges, measuredNodes)) {
        bool alongU = false;
        if (!wantsHalving(nodes[node], alongU)) {
            continue;
        }
        if (vertices.size() + kMostNewVertices > capacity) {
            ++refused_;
        } else {
            halve(node, alongU);
        }
    }
    for (std::uint32_t edge = firstEdge; edge < edges.size(); ++edge) {
        if (edges[edge].isLive) {
            liveEdges.push_back(edge);
        }
    }
    return firstNode;
}

void LaunchMesh::settle() {
    for (MeshEdge& edge : edges) {
        edge.split = edge.strong;
    }
    // children are behind their parents
    for (std::size_t i = edges.size(); i-- > 0;) {
        if (edges[i].parent != kNone) {
            edges[edges[i].parent].split |= edges[i].split;
        }
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
        MeshNode& node = nodes[i];
        if (node.isLeaf()) {
            continue;
        }
        Samples off = node.strong;
        for (const std::uint32_t edge : node.edges) {
            off |= edges[edge].split;
        }
        node.fine = stepsAt(off) | nodes[node.children[0]].fine | nodes[node.children[1]].fine;
    }
}

Samples LaunchMesh::liveSamples(std::uint32_t vertex) const {
    const MeshVertex& self = vertices[vertex];
    if (self.parents[0] == kNone) {
        return kAllSamples;
    }
    Samples live = self.isRay ? kAllSamples : 0;
    if (self.edge != kNone && edges[self.edge].parent != kNone) {
        live &= edges[edges[self.edge].parent].split;
    }
    if (!self.isRay || isFirstWindow_) {
        return live;
    }
    // the first sample belongs to the window before, which did not know a new ray and has placed the others
    return self.isNew ? live & ~Samples(1) : live | 1;
}

void LaunchMesh::verticesOf(std::uint32_t index, std::uint32_t (&out)[9]) const {
    const MeshNode& node = nodes[index];
    const auto middle = [&](int side) { return edges[node.edges[side]].middle; };
    const std::uint32_t rows[9] = {node.corners[0], middle(0),   node.corners[1], middle(3),      node.centre,
                                   middle(1),       node.corners[3], middle(2),   node.corners[2]};
    std::copy(std::begin(rows), std::end(rows), out);
}

glm::vec2 LaunchMesh::launchOf(const MeshVertex& vertex, const LaunchFrame& frame) {
    const glm::dvec2 cells(frame.cellsU, frame.cellsV);
    return glm::vec2(2.0 * glm::dvec2(vertex.place) / (cells * double(kCellUnits)) - 1.0);
}

Samples LaunchMesh::weakSteps(const MeshNode& node) const {
    Samples off = node.strong | node.weak;
    for (const std::uint32_t edge : node.edges) {
        off |= edges[edge].strong | edges[edge].weak;
    }
    return stepsAt(off);
}

} // namespace eikonal::bake

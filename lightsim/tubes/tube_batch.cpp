#include "lightsim/tubes/tube_batch.h"

#include <algorithm>
#include <bit>

#include "lightsim/tubes/power_of_rays.h"

namespace eikonal::bake {

namespace {

Samples samplesOf(const glm::uvec2& words) { return Samples(words.y) << 32 | words.x; }

glm::uvec2 wordsOf(Samples samples) { return {std::uint32_t(samples), std::uint32_t(samples >> 32)}; }

constexpr Samples kAllSteps = kAllSamples >> 1;

std::uint32_t frameOfCell(const LaunchGrids& grids, std::uint32_t cell) {
    const auto next = std::upper_bound(grids.frames.begin(), grids.frames.end(), cell,
                                       [](std::uint32_t c, const LaunchFrame& frame) { return c < frame.firstCell; });
    return std::uint32_t(next - grids.frames.begin()) - 1;
}

} // namespace

TubeBatch::TubeBatch(TubeKernels& kernels, const LaunchGrids& grids, const Lattice& domain, std::span<const std::uint32_t> cells,
                     std::uint32_t capacity)
    : kernels_(kernels), grids_(grids), domain_(domain), capacity_(capacity), rootCount_(std::uint32_t(cells.size())),
      isDone_(cells.size(), 0) {
    mesh_.reserve(capacity);
    for (const std::uint32_t cell : cells) {
        const std::uint32_t frame = frameOfCell(grids, cell);
        mesh_.addCell(frame, grids.frames[frame], cell - grids.frames[frame].firstCell);
    }
}

void TubeBatch::begin(std::uint32_t window) {
    kernels_.beginWindow(window * TUBE_STEPS);
    if (window == 0) {
        for (std::uint32_t i = 0; i < mesh_.vertices.size(); ++i) {
            mesh_.makeRay(i);
        }
    } else {
        mesh_.beginWindow();
    }
    isAlive_.assign(mesh_.nodes.size(), window == 0);
    isActive_.assign(mesh_.vertices.size(), window == 0);
    hasEnded_.resize(mesh_.vertices.size(), 0);
    if (window > 0) {
        for (std::uint32_t root = 0; root < rootCount_; ++root) {
            if (isDone_[root] == 0) {
                markAlive(root);
            }
        }
    }
    placeNew();
}

/// A node is alive while one of its rays, or of its children's, is; then all of its vertices have tracks.
bool TubeBatch::markAlive(std::uint32_t index) {
    const MeshNode& node = mesh_.nodes[index];
    std::uint32_t vertices[9];
    mesh_.verticesOf(index, vertices);
    bool alive = std::any_of(std::begin(vertices), std::end(vertices),
                             [&](std::uint32_t v) { return mesh_.vertices[v].isRay && hasEnded_[v] == 0; });
    if (!node.isLeaf()) {
        const bool first = markAlive(node.children[0]);
        const bool second = markAlive(node.children[1]);
        alive = alive || first || second;
    }
    isAlive_[index] = alive;
    if (alive) {
        for (const std::uint32_t v : vertices) {
            isActive_[v] = 1;
        }
    }
    return alive;
}

void TubeBatch::placeNew() {
    kernels_.makeRoomFor(mesh_.vertices.size());
    std::vector<TubePlacement> vertices;
    for (std::uint32_t i = placedVertices_; i < mesh_.vertices.size(); ++i) {
        const MeshVertex& vertex = mesh_.vertices[i];
        vertices.push_back({LaunchMesh::launchOf(vertex, grids_.frames[vertex.frame]), vertex.frame, i});
    }
    if (!vertices.empty()) {
        kernels_.place(vertices);
    }
    std::vector<TubeNode> nodes(mesh_.nodes.size() - placedNodes_);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        mesh_.verticesOf(std::uint32_t(placedNodes_ + i), nodes[i].vertices);
        nodes[i].frameIndex = mesh_.vertices[nodes[i].vertices[0]].frame;
    }
    kernels_.placeNodes(placedNodes_, nodes);
    placedVertices_ = std::uint32_t(mesh_.vertices.size());
    placedNodes_ = std::uint32_t(mesh_.nodes.size());
    isActive_.resize(placedVertices_, 1);
    hasEnded_.resize(placedVertices_, 0);
    isAlive_.resize(placedNodes_, 1);
}

void TubeBatch::propagate() {
    std::vector<std::uint32_t> rays;
    for (std::uint32_t i = 0; i < mesh_.vertices.size(); ++i) {
        if (isActive_[i] != 0 && mesh_.vertices[i].isRay) {
            rays.push_back(i);
        }
    }
    kernels_.trace(rays);
    conformFrom(0, false);
}

bool TubeBatch::refine() {
    std::vector<std::uint32_t> edges, nodes;
    for (std::uint32_t i = 0; i < mesh_.edges.size(); ++i) {
        if (mesh_.edges[i].isLive && isActive_[mesh_.edges[i].middle] != 0) {
            edges.push_back(i);
        }
    }
    for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) {
        if (isAlive_[i] != 0) {
            nodes.push_back(i);
        }
    }
    while (!edges.empty() || !nodes.empty()) {
        measure(edges, nodes);
        std::vector<std::uint32_t> liveEdges;
        const std::uint32_t firstNode = mesh_.refine(capacity_, edges, nodes, liveEdges);
        edges = std::move(liveEdges);
        if (mesh_.refusedHalvings() > 0 && rootCount_ > 1) {
            return false;
        }
        nodes.resize(mesh_.nodes.size() - firstNode);
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            nodes[i] = firstNode + i;
        }
        traceNew(edges, firstNode);
    }
    mesh_.settle();
    presences_ = kernels_.presences(placedVertices_);
    return true;
}

void TubeBatch::traceNew(const std::vector<std::uint32_t>& edges, std::uint32_t firstNode) {
    const std::uint32_t firstVertex = placedVertices_;
    placeNew();
    std::vector<std::uint32_t> rays;
    const auto makeRay = [&](std::uint32_t vertex) {
        if (!mesh_.vertices[vertex].isRay) {
            mesh_.makeRay(vertex);
            rays.push_back(vertex);
        }
    };
    for (const std::uint32_t edge : edges) {
        makeRay(mesh_.edges[edge].middle);
    }
    for (std::uint32_t node = firstNode; node < mesh_.nodes.size(); ++node) {
        makeRay(mesh_.nodes[node].centre);
    }
    if (!rays.empty()) {
        kernels_.trace(rays);
    }
    conformFrom(firstVertex, false);
}

void TubeBatch::measure(const std::vector<std::uint32_t>& edges, const std::vector<std::uint32_t>& nodes) {
    std::vector<TubeEdge> items(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const MeshEdge& edge = mesh_.edges[edges[i]];
        items[i] = {edge.middle, edge.ends[0], edge.ends[1], 0};
    }
    const TubeKernels::Measures measures = kernels_.measure(items, nodes);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        mesh_.edges[edges[i]].strong = samplesOf(measures.edges[i].strong);
        mesh_.edges[edges[i]].weak = samplesOf(measures.edges[i].weak);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        mesh_.nodes[nodes[i]].strong = samplesOf(measures.nodes[i].strong);
        mesh_.nodes[nodes[i]].weak = samplesOf(measures.nodes[i].weak);
        mesh_.nodes[nodes[i]].launchShare = measures.nodes[i].launchShare;
    }
}

/// Parents before children: a generation at a time.
void TubeBatch::conformFrom(std::uint32_t firstVertex, bool withRays) {
    std::vector<std::vector<TubeConformity>> generations;
    for (std::uint32_t i = firstVertex; i < mesh_.vertices.size(); ++i) {
        if (isActive_[i] == 0 || (mesh_.vertices[i].isRay && !withRays)) {
            continue;
        }
        const Samples live = mesh_.liveSamples(i);
        if (live != kAllSamples) {
            const MeshVertex& vertex = mesh_.vertices[i];
            generations.resize(std::max<std::size_t>(generations.size(), vertex.depth + 1));
            generations[vertex.depth].push_back({i, vertex.parents[0], vertex.parents[1], 0, wordsOf(live), {}});
        }
    }
    for (const auto& generation : generations) {
        if (!generation.empty()) {
            kernels_.conform(generation);
        }
    }
}

void TubeBatch::conform() {
    conformFrom(0, true);
}

Samples TubeBatch::stepsNear(std::uint32_t index) const {
    std::uint32_t vertices[9];
    mesh_.verticesOf(index, vertices);
    Samples near = 0;
    for (const std::uint32_t v : vertices) {
        near |= mesh_.vertices[v].isRay ? samplesOf(presences_[v].near) : 0;
    }
    return near;
}

/// A vertex that conforms to others bends where they do.
void TubeBatch::findBends() {
    bends_.assign(mesh_.vertices.size(), 0);
    for (std::uint32_t i = 0; i < mesh_.vertices.size(); ++i) {  // parents have lower numbers
        const MeshVertex& vertex = mesh_.vertices[i];
        bends_[i] = vertex.isRay ? samplesOf(presences_[i].bent) : 0;
        if (mesh_.liveSamples(i) != kAllSamples) {
            bends_[i] |= bends_[vertex.parents[0]] | bends_[vertex.parents[1]];
        }
    }
}

/// Steps that cannot be deposited as one with the step before them.
Samples TubeBatch::bentSteps(std::uint32_t index) const {
    std::uint32_t vertices[9];
    mesh_.verticesOf(index, vertices);
    Samples bent = 0;
    for (const std::uint32_t v : vertices) {
        bent |= bends_[v];
    }
    return bent | bent << 1;
}

void TubeBatch::listJobs(std::uint32_t index, Samples steps, std::vector<TubeJob>& jobs) const {
    const MeshNode& node = mesh_.nodes[index];
    if (isAlive_[index] == 0 || steps == 0) {
        return;
    }
    const Samples bent = bentSteps(index);
    const Samples weak = node.isLeaf() ? mesh_.weakSteps(node) : 0;
    for (Samples own = steps & ~node.fine & stepsNear(index); own != 0;) {
        const int first = std::countr_zero(own);
        int count = 1;
        while (count < TUBE_MAX_JOB_STEPS && (own >> (first + count) & 1) != 0 && (bent >> (first + count) & 1) == 0) {
            ++count;
        }
        const Samples taken = ((Samples(1) << count) - 1) << first;
        const std::uint32_t isWeak = (weak & taken) != 0 ? 1u : 0u;
        jobs.push_back({index, std::uint32_t(first) | std::uint32_t(count) << TUBE_JOB_COUNT_BIT | isWeak << TUBE_JOB_WEAK_BIT});
        own &= ~taken;
    }
    if (!node.isLeaf()) {
        listJobs(node.children[0], steps & node.fine, jobs);
        listJobs(node.children[1], steps & node.fine, jobs);
    }
}

std::uint64_t TubeBatch::deposit(const Deposits& deposits) {
    findBends();
    std::vector<TubeJob> jobs;
    for (std::uint32_t root = 0; root < rootCount_; ++root) {
        listJobs(root, kAllSteps, jobs);
    }
    kernels_.deposit(jobs, deposits);
    return jobs.size();
}

/// Cell by cell, so that what else is in the batch makes no difference.
bool TubeBatch::isFinished(double share) {
    std::vector<double> remaining(mesh_.vertices.size());
    for (std::uint32_t i = 0; i < remaining.size(); ++i) {  // parents have lower numbers
        const MeshVertex& vertex = mesh_.vertices[i];
        if (vertex.isRay) {
            remaining[i] = isActive_[i] != 0 ? presences_[i].remaining : 0.0;
            hasEnded_[i] = isActive_[i] != 0 ? presences_[i].ended != 0 : hasEnded_[i];
        } else {
            remaining[i] = 0.5 * (remaining[vertex.parents[0]] + remaining[vertex.parents[1]]);
        }
    }
    std::vector<glm::dvec2> powers(rootCount_, glm::dvec2(0.0));  // left, launched
    for (std::uint32_t index = 0; index < mesh_.nodes.size(); ++index) {
        const MeshNode& node = mesh_.nodes[index];
        if (node.isLeaf()) {
            mesh_.forEachQuarterCorner(index, [&](int quarter, std::uint32_t vertex) {
                powers[node.root] += node.launchShare[quarter] * glm::dvec2(remaining[vertex], 1.0);
            });
        }
    }
    bool finished = true;
    for (std::uint32_t root = 0; root < rootCount_; ++root) {
        isDone_[root] = isDone_[root] != 0 || powers[root].x <= share * powers[root].y;
        finished = finished && isDone_[root] != 0;
    }
    return finished;
}

void TubeBatch::tally() {
    const std::vector<glm::dvec4> powers = powerOfRays(mesh_, grids_, domain_);
    const std::vector<glm::vec4> rounded(powers.begin(), powers.end());
    kernels_.tally(rounded);
}

std::vector<PowerByCrossing> TubeBatch::reflected() const {
    return reflectedByRoot(mesh_, grids_, kernels_.reflections(placedVertices_), rootCount_);
}

} // namespace eikonal::bake

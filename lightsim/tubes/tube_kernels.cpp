#include "lightsim/tubes/tube_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <initializer_list>

#include "shaders/shared/bindings.h"

namespace eikonal::bake {

namespace {

// The trace's answer begins with its count of field evaluations.
constexpr std::size_t kPresenceHeader = 4 * sizeof(std::uint32_t);
constexpr std::size_t kCellsPerJob = 4;
constexpr std::size_t kFirstJobs = 1024;  // room for so many is made at once

std::vector<std::string> withGathers(std::vector<std::string> defines, int gathersPerPart) {
    defines.push_back("GATHERS_PER_PART " + std::to_string(gathersPerPart));
    return defines;
}

bool has(const std::vector<std::string>& defines, std::string_view define) {
    return std::find(defines.begin(), defines.end(), define) != defines.end();
}

/// See tracks.glsl.
int wordsPerShare(const std::vector<std::string>& defines, bool followsReflections) {
    return has(defines, "BANDS 3") ? 4 : followsReflections ? 2 : 1;
}

std::size_t partBytes(std::size_t jobs) {
    return sizeof(TubePartsHeader) + TUBE_LISTS * jobs * kCellsPerJob * TUBE_MAX_PARTS * sizeof(std::uint32_t);
}

/// A byte a voxel.
std::size_t freeSampleWords(const std::vector<std::string>& defines, const Lattice& lattice) {
    return has(defines, "EFFECT_OPAQUE") ? (lattice.count() + 3) / 4 : 0;
}

} // namespace

TubeKernels::Portions TubeKernels::portionsFor(const gpu::DeviceLimits& limits) {
    return limits.isProcessor ? Portions{1, 4096, 4096} : Portions{8, TUBE_MAX_JOBS, 65536};
}

TubeKernels::TubeKernels(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice,
                         std::uint32_t capacity, bool followsReflections)
    : context_(context), portions_(portionsFor(context.limits())), defines_(withGathers(defines, portions_.gathersPerPart)),
      capacity_(capacity), followsReflections_(followsReflections),
      vertices_(context, 0, "tube vertices"), frames_(context, sizeof(LaunchFrame), "launch frames"),
      nodes_(context, 0, "tube nodes"), items_(context, 0, "tube items"),
      presences_(context, kPresenceHeader, "tube presences"), edgeMeasures_(context, 0, "measures of edges"),
      nodeMeasures_(context, 0, "measures of nodes"), reflections_(context, 0, "tube reflections"),
      parts_(context, partBytes(0), "tube parts"),
      freeSamples_(context, freeSampleWords(defines, lattice) * sizeof(std::uint32_t), "free samples"),
      ledger_(context, LEDGER_ROWS * 3 * 2 * sizeof(std::uint32_t), "bake ledger"),
      settingsBlock_(context, sizeof(BakeSettings), "bake settings"),
      tubeBlock_(context, sizeof(TubeSettings), "tube settings"),
      positions_(context, 0, "tube positions"), shares_(context, 0, "tube shares", wordsPerShare(defines, followsReflections)),
      cells_(context, 0, "tube cells"),
      place_(context, "lightsim/tubes/place.comp.glsl", defines_), trace_(context, "lightsim/tubes/trace.comp.glsl", defines_),
      measureEdges_(context, "lightsim/tubes/measure_edges.comp.glsl", defines_),
      measureNodes_(context, "lightsim/tubes/measure_nodes.comp.glsl", defines_),
      conform_(context, "lightsim/tubes/conform.comp.glsl", defines_),
      sortCells_(context, "lightsim/tubes/sort_cells.comp.glsl", defines_),
      smoothCells_(context, "lightsim/tubes/smooth_cells.comp.glsl", defines_),
      sortParts_(context, "lightsim/tubes/sort_parts.comp.glsl", defines_),
      tally_(context, "lightsim/tubes/tally.comp.glsl", defines_), intoSums_(context, defines_) {
    if (has(defines, "EFFECT_OPAQUE")) {
        countFreeSamples_.emplace(context, "lightsim/tubes/free_samples.comp.glsl", defines_);
    }
}

TubeKernels::DepositKernels::DepositKernels(const gpu::Context& context, const std::vector<std::string>& defines)
    : gather(context, "lightsim/tubes/deposit_gather.comp.glsl", defines),
      lines(context, "lightsim/tubes/deposit_lines.comp.glsl", defines),
      rays(context, "lightsim/tubes/deposit_rays.comp.glsl", defines) {
    if (has(defines, "EFFECT_OPAQUE")) {
        std::vector<std::string> inCut = defines;
        inCut.emplace_back("CUT_VOXELS");
        gatherInCut.emplace(context, "lightsim/tubes/deposit_gather.comp.glsl", inCut);
    }
}

const TubeKernels::DepositKernels& TubeKernels::depositKernels(const VoxelSums& sums) {
    if (!sums.areLobes()) {
        return intoSums_;
    }
    if (!intoLobes_) {
        intoLobes_.emplace(context_, withLobes(defines_));
    }
    return *intoLobes_;
}

void TubeKernels::setLights(const gpu::Context& context, const LaunchGrids& grids, const TubeSettings& tubeSettings) {
    frames_ = gpu::Buffer(context, grids.frames.size() * sizeof(LaunchFrame), "launch frames");
    frames_.upload(std::span<const LaunchFrame>(grids.frames));
    tubeSettings_ = tubeSettings;
}

void TubeKernels::setMirrors(const Mirrors& mirrors) {
    tubeSettings_.mirrorCount = std::uint32_t(mirrors.size());
    tubeSettings_.mirrors = packed(mirrors);
}

void TubeKernels::restart(const BakeSettings& settings) {
    settingsBlock_.upload(settings);
    presences_.fill(0);
    ledger_.fill(0);
    TubePartsHeader header{};
    parts_.upload(header);
    if (countFreeSamples_) {
        freeSamples_.bindStorage(TUBE_FREE_SAMPLES_BINDING);
        run(*countFreeSamples_, freeSamples_.bytes() / sizeof(std::uint32_t));
    }
}

void TubeKernels::bindTracks() const {
    vertices_.bindStorage(TUBE_VERTICES_BINDING);
    positions_.bindStorage(TUBE_POSITIONS_BINDING);
    positions_.bindTexels(gpu::kUnitTubePositions);
    shares_.bindStorage(TUBE_SHARES_BINDING);
    shares_.bindTexels(gpu::kUnitTubeShares);
    frames_.bindStorage(TUBE_FRAMES_BINDING);
    items_.bindStorage(TUBE_ITEMS_BINDING);
    nodes_.bindStorage(TUBE_NODES_BINDING);
}

void TubeKernels::run(const gpu::Kernel& kernel, std::size_t items, std::size_t invocationsPerItem) {
    tubeSettings_.itemCount = std::uint32_t(items);
    tubeBlock_.upload(tubeSettings_);
    settingsBlock_.bindUniform(BAKE_SETTINGS_BINDING);
    tubeBlock_.bindUniform(TUBE_SETTINGS_BINDING);
    const std::size_t invocations = items * invocationsPerItem;
    kernel.dispatch({(invocations + BAKE_GROUP_SIZE - 1) / BAKE_GROUP_SIZE, 1, 1});
}

/// The invocations for everything that is listed.
gpu::Kernel::Indirect TubeKernels::listed(const gpu::Kernel& kernel, std::size_t list) {
    return {kernel, list * sizeof(TubePartList) + offsetof(TubePartList, groups)};
}

void TubeKernels::makeRoomFor(std::size_t vertexCount) {
    const std::size_t room = std::max<std::size_t>(
        vertexCount, std::min(capacity_, std::bit_ceil(std::max(std::uint32_t(vertexCount), portions_.firstVertices))));
    vertices_.grow(room * sizeof(TubeVertex));
    nodes_.grow(room * sizeof(TubeNode));
    presences_.grow(kPresenceHeader + room * sizeof(TubePresence));
    edgeMeasures_.grow(room * sizeof(TubeMeasure));
    nodeMeasures_.grow(room * sizeof(TubeMeasure));
    reflections_.grow(followsReflections_ ? room * sizeof(TubeReflections) : 0);
    positions_.grow(room * TUBE_SAMPLES * sizeof(glm::vec4));
    shares_.grow(room * TUBE_SAMPLES * std::size_t(wordsPerShare(defines_, followsReflections_)) * sizeof(float));
}

void TubeKernels::place(std::span<const TubePlacement> vertices) {
    uploadItems(vertices);
    bindTracks();
    run(place_, vertices.size());
}

void TubeKernels::placeNodes(std::uint32_t first, std::span<const TubeNode> nodes) {
    nodes_.uploadBytes(first * sizeof(TubeNode), nodes.data(), nodes.size_bytes());
}

void TubeKernels::trace(std::span<const std::uint32_t> vertices) {
    uploadItems(vertices);
    bindTracks();
    presences_.bindStorage(TUBE_RESULTS_BINDING);
    reflections_.bindStorage(TUBE_REFLECTIONS_BINDING);
    run(trace_, vertices.size());
}

TubeKernels::Measures TubeKernels::measure(std::span<const TubeEdge> edges, std::span<const std::uint32_t> nodes) {
    if (!edges.empty()) {
        uploadItems(edges);
        bindTracks();
        edgeMeasures_.bindStorage(TUBE_RESULTS_BINDING);
        run(measureEdges_, edges.size());
    }
    if (!nodes.empty()) {
        uploadItems(nodes);
        bindTracks();
        nodeMeasures_.bindStorage(TUBE_RESULTS_BINDING);
        run(measureNodes_, nodes.size());
    }
    return {edgeMeasures_.download<TubeMeasure>(edges.size()), nodeMeasures_.download<TubeMeasure>(nodes.size())};
}

void TubeKernels::conform(std::span<const TubeConformity> conformities) {
    uploadItems(conformities);
    bindTracks();
    run(conform_, conformities.size());
}

std::vector<TubePresence> TubeKernels::presences(std::uint32_t count) const {
    std::vector<TubePresence> result(count);
    presences_.downloadBytes(kPresenceHeader, result.data(), count * sizeof(TubePresence));
    return result;
}

void TubeKernels::deposit(std::span<const TubeJob> jobs, const Deposits& deposits) {
    for (std::size_t begin = 0; begin < jobs.size(); begin += portions_.jobs) {
        depositChunk(jobs.subspan(begin, std::min(portions_.jobs, jobs.size() - begin)), deposits);
    }
}

void TubeKernels::depositChunk(std::span<const TubeJob> jobs, const Deposits& deposits) {
    const std::size_t room = std::bit_ceil(std::max(jobs.size(), kFirstJobs));
    cells_.grow(room * kCellsPerJob * TUBE_MOST_CELL_ROWS * sizeof(glm::vec4));
    parts_.grow(partBytes(room));
    uploadItems(jobs);
    bindTracks();
    std::array<TubePartList, TUBE_LISTS> lists{};
    lists.fill({{0, 1, 1}, 0});
    parts_.upload(lists);  // the count of folded cells behind them goes on
    cells_.bindStorage(TUBE_SORT_RECORDS_BINDING);
    cells_.bindTexels(gpu::kUnitTubeCells);
    parts_.bindStorage(TUBE_SORT_PARTS_BINDING);
    run(sortCells_, jobs.size(), kCellsPerJob);
    gpu::Kernel::dispatchTogether(parts_, {listed(smoothCells_, TUBE_EVEN_LIST), listed(sortParts_, TUBE_UNEVEN_LIST)});
    deposits.light.bind();
    parts_.bindStorage(TUBE_PARTS_BINDING);
    const DepositKernels& into = depositKernels(deposits.light);
    gpu::Kernel::dispatchTogether(parts_, {listed(into.gather, TUBE_GATHER_LIST), listed(into.lines, TUBE_LINE_LIST),
                                           listed(into.rays, TUBE_RAY_LIST)});
    if (into.gatherInCut) {
        freeSamples_.bindStorage(TUBE_FREE_SAMPLES_BINDING);
        gpu::Kernel::dispatchTogether(parts_, {listed(*into.gatherInCut, TUBE_CUT_LIST)});
    }
    if (deposits.eikonal != nullptr) {
        deposits.eikonal->add(parts_);
    }
}

void TubeKernels::tally(std::span<const glm::vec4> powers) {
    uploadItems(powers);
    bindTracks();
    ledger_.bindStorage(BAKE_LEDGER_BINDING);
    items_.bindStorage(TUBE_RESULTS_BINDING);
    run(tally_, powers.size());
}

std::uint64_t TubeKernels::foldedCells() const { return parts_.download<TubePartsHeader>(1).front().foldedCells; }

std::uint64_t TubeKernels::fieldEvaluations() const {
    std::array<std::uint32_t, 2> words;
    presences_.downloadBytes(0, words.data(), sizeof words);
    return (std::uint64_t(words[1]) << 32) | words[0];
}

std::size_t TubeKernels::bytes() const {
    std::size_t sum = 0;
    const std::initializer_list<const gpu::Buffer*> buffers = {
        &vertices_, &frames_, &nodes_, &items_, &presences_, &edgeMeasures_, &nodeMeasures_, &reflections_, &parts_,
        &freeSamples_, &ledger_, &settingsBlock_, &tubeBlock_, &positions_, &shares_, &cells_};
    for (const gpu::Buffer* buffer : buffers) {
        sum += buffer->bytes();
    }
    return sum;
}

} // namespace eikonal::bake

#include "lightsim/tubes/tube_bake.h"

#include <algorithm>
#include <vector>

#include "common/interrupt.h"
#include "lightsim/settings.h"
#include "shaders/shared/bindings.h"

namespace eikonal::bake {

namespace {

constexpr std::uint32_t kProbes = 16;       // cells of the first batch; later ones follow what these needed
constexpr std::uint32_t kMostNeeded = 1024; // vertices a cell, on the whole: with room for those, nothing is probed
constexpr std::uint32_t kMostCells = 4096;  // in a batch
constexpr double kFilling = 0.45;           // of the capacity that a batch is meant to need
constexpr double kFollowedShare = 0.05;     // of the tolerance, times the power launched: reflections with less are let go

bool hasBoundaries(const MethodPlan& plan) {
    return std::find(plan.defines.begin(), plan.defines.end(), "EFFECT_REFLECTION") != plan.defines.end();
}

std::vector<std::string> definesFor(const MethodPlan& plan, bool followsReflections, bool hasDetail) {
    std::vector<std::string> defines = plan.defines;
    if (hasDetail) {
        defines.push_back("FIELD_DETAIL");
    }
    if (followsReflections) {
        defines.push_back("FOLLOW_REFLECTIONS");
    }
    return defines;
}

/// Some from all over the path come first: what they need, cells will on the whole.
std::vector<std::uint32_t> withProbesFirst(const std::vector<std::uint32_t>& cells) {
    std::vector<std::uint32_t> ordered, others;
    const std::size_t spacing = std::max<std::size_t>(cells.size() / kProbes, 1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool isProbe = i % spacing == spacing / 2 && ordered.size() < kProbes;
        (isProbe ? ordered : others).push_back(cells[i]);
    }
    ordered.insert(ordered.end(), others.begin(), others.end());
    return ordered;
}

/// A GPU has more to do at a time with more rays; their tracks are blocks.
std::uint32_t verticesFor(const gpu::DeviceLimits& limits) {
    constexpr std::uint32_t kOnProcessor = 65536, kOnGpu = 262144;
    const std::size_t most = limits.maxStorageBlockBytes / (TUBE_SAMPLES * sizeof(glm::vec4));
    return std::uint32_t(std::min<std::size_t>(limits.isProcessor ? kOnProcessor : kOnGpu, most));
}

std::optional<gpu::Texture3D> detailOf(const gpu::Context& context, const Fields& fields) {
    const DenseGrid<unsigned char> distance = distanceToDetail(fields);
    return isAnywhere(distance) ? std::optional(detailTexture(context, distance)) : std::nullopt;
}

} // namespace

TubeBake::TubeBake(const gpu::Context& context, const MethodPlan& plan, const BakeOptions& options, const LaunchGrids& grids,
                   const BakeSettings& settings)
    : accuracy_(plan.accuracy), fields_(plan.fields), grids_(&grids), settings_(settings),
      capacity_(options.tubeVertices > 0 ? options.tubeVertices : verticesFor(context.limits())),
      layers_(layersPerSlab(plan.fields.lattice, plan.blockBytes)),
      followsReflections_(plan.accuracy.reflections > 0 && hasBoundaries(plan)),
      detail_(detailOf(context, plan.fields)),
      kernels_(context, definesFor(plan, followsReflections_, detail_.has_value()), plan.fields.lattice, capacity_,
               followsReflections_),
      sums_(context, plan.fields.lattice, layers_, plan.bands) {
    if (options.eikonal) {
        eikonal_.emplace(context, definesFor(plan, followsReflections_, detail_.has_value()), plan.fields.lattice, layers_);
    }
    setLights(context, grids, settings);
}

void TubeBake::setFields(const gpu::Context& context, const Fields& fields) {
    if (detail_) {
        detail_ = detailTexture(context, distanceToDetail(fields));
    }
}

void TubeBake::setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) {
    grids_ = &grids;
    settings_ = settings;
    kernels_.setLights(context, grids, tubeSettingsOf(accuracy_, fields_));
}

/// The method: propagate, refine, conform, deposit, until no light is left. False: the batch needs more rays than there is
/// room for, and `window` is the first that is not deposited.
bool TubeBake::bake(TubeBatch& batch, const CellRange& cells, const Deposits& deposits, std::uint32_t& window) {
    const std::uint32_t maxWindows = settings_.maxSteps / TUBE_STEPS + 1;
    for (window = 0; window < maxWindows; ++window) {
        throwIfInterrupted();
        batch.begin(window);
        batch.propagate();
        if (!batch.refine()) {
            return false;
        }
        batch.conform();
        if (window >= cells.firstDeposit) {
            counts_.steps += batch.deposit(deposits);
        }
        if (batch.isFinished(settings_.cullShare)) {
            break;
        }
    }
    batch.tally();
    return true;
}

void TubeBake::countBatch(const TubeBatch& batch, std::size_t cells) {
    counts_.peak = std::max<std::uint64_t>(counts_.peak, batch.nodeCount());
    counts_.refusedSplits += batch.refusedHalvings();
    counts_.splits += (batch.nodeCount() - cells) / 2;
}

/// The light of one path, batch after batch. A batch that needs more rays than there is room for is begun again in halves.
ReflectedLight TubeBake::follow(const LightPath& path, const Deposits& deposits,
                                const std::function<void(double)>& progress) {
    kernels_.setMirrors(path.mirrors);
    const std::uint32_t cellCount = std::uint32_t(path.cells.size());
    const bool isProbed = cellCount > capacity_ / kMostNeeded;
    const std::vector<std::uint32_t> pathCells = isProbed ? withProbesFirst(path.cells) : path.cells;
    ReflectedLight reflected;
    std::vector<CellRange> waiting;
    std::uint32_t nextCell = 0;
    std::uint32_t batchCells = isProbed ? kProbes : cellCount;
    double probed = 0.0;  // vertices a cell
    while (nextCell < cellCount || !waiting.empty()) {
        if (waiting.empty()) {
            waiting.push_back({nextCell, std::min(batchCells, cellCount - nextCell), 0});
            nextCell += waiting.back().count;
        }
        const CellRange range = waiting.back();
        waiting.pop_back();
        const auto cells = std::span(pathCells).subspan(range.first, range.count);
        TubeBatch batch(kernels_, *grids_, fields_.lattice, cells, capacity_);
        std::uint32_t window = 0;
        if (bake(batch, range, deposits, window)) {
            countBatch(batch, cells.size());
            if (followsReflections_) {
                reflected.add(cells, batch.reflected());
            }
            const double needed = double(batch.vertexCount()) / double(range.count);
            probed = probed == 0.0 ? needed : probed;
            batchCells = std::clamp(std::uint32_t(kFilling * capacity_ / std::max(probed, needed)), 1u, kMostCells);
        } else {
            const std::uint32_t half = range.count / 2;
            const std::uint32_t firstDeposit = std::max(window, range.firstDeposit);
            waiting.push_back({range.first + half, range.count - half, firstDeposit});
            waiting.push_back({range.first, half, firstDeposit});
        }
        if (progress) {
            progress(double(nextCell) / double(cellCount));
        }
    }
    return reflected;
}

void TubeBake::propagate(int begin, int end, const std::function<void(double)>& progress) {
    sums_.clear();
    if (eikonal_) {
        eikonal_->clear();
    }
    run(begin, end, {sums_, eikonal_ ? &*eikonal_ : nullptr}, progress);
}

void TubeBake::propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) {
    run(bins.tile().slabBegin, bins.tile().slabEnd, {bins}, progress);
}

void TubeBake::run(int begin, int end, const Deposits& deposits, const std::function<void(double)>& progress) {
    settings_.slabBegin = begin;
    settings_.slabEnd = end;
    counts_ = {};
    if (detail_) {
        detail_->bind(gpu::kUnitDetail);
    }
    kernels_.restart(settings_);
    const double leastPower = kFollowedShare * accuracy_.tolerance * grids_->strongestPower;
    std::vector<LightPath> paths{pathFromSource(*grids_)};
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const LightPath path = std::move(paths[i]);
        const ReflectedLight reflected = follow(path, deposits, progress);
        if (path.mirrors.size() < std::size_t(accuracy_.reflections)) {
            const std::vector<LightPath> more = reflected.pathsBehind(path.mirrors, leastPower);
            paths.insert(paths.end(), more.begin(), more.end());
        }
    }
    counts_.fieldEvaluations = kernels_.fieldEvaluations();
    counts_.folds = kernels_.foldedCells();
}

void TubeBake::read(const DenseGrid<float>& opaque, BakedLight& light) const {
    sums_.read(settings_, opaque, light);
    if (eikonal_) {
        eikonal_->read(settings_, light.eikonal);
    }
}

} // namespace eikonal::bake

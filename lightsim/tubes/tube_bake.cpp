#include "lightsim/tubes/tube_bake.h"

#include <algorithm>
#include <vector>

#include "common/interrupt.h"
#include "lightsim/settings.h"

namespace eikonal::bake {

namespace {

constexpr std::uint32_t kFirstBatch = 16;   // cells; later ones follow what these needed
constexpr std::uint32_t kMostCells = 4096;  // in a batch
constexpr double kFilling = 0.35;           // of the capacity that a batch is meant to need

} // namespace

TubeBake::TubeBake(const gpu::Context& context, const MethodPlan& plan, std::uint32_t capacity, const LaunchGrids& grids,
                   const BakeSettings& settings)
    : accuracy_(plan.accuracy), fields_(plan.fields), grids_(&grids), settings_(settings), capacity_(capacity),
      layers_(layersPerSlab(plan.fields.lattice, plan.blockBytes)), kernels_(context, plan.defines, capacity),
      sums_(context, plan.fields.lattice, layers_, plan.bands) {
    setLights(context, grids, settings);
}

void TubeBake::setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) {
    grids_ = &grids;
    settings_ = settings;
    kernels_.setLights(context, grids, tubeSettingsOf(accuracy_, fields_));
}

/// The method: propagate, refine, conform, deposit, until no light is left. False: the batch needs more rays than there is
/// room for, and `window` is the first that is not deposited.
bool TubeBake::bake(TubeBatch& batch, const CellRange& cells, const VoxelSums& sums, std::uint32_t& window) {
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
            counts_.steps += batch.deposit(sums);
        }
        if (batch.isFinished(settings_.cullShare)) {
            break;
        }
    }
    batch.tally();
    return true;
}

void TubeBake::propagate(int begin, int end, const std::function<void(double)>& progress) {
    sums_.clear();
    run(begin, end, sums_, progress);
}

void TubeBake::propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) {
    run(bins.tile().slabBegin, bins.tile().slabEnd, bins, progress);
}

void TubeBake::run(int begin, int end, const VoxelSums& sums, const std::function<void(double)>& progress) {
    settings_.slabBegin = begin;
    settings_.slabEnd = end;
    counts_ = {};
    kernels_.restart(settings_);
    std::vector<CellRange> waiting;
    std::uint32_t nextCell = 0;
    std::uint32_t batchCells = kFirstBatch;
    while (nextCell < grids_->cellCount || !waiting.empty()) {
        if (waiting.empty()) {
            waiting.push_back({nextCell, std::min(batchCells, grids_->cellCount - nextCell), 0});
            nextCell += waiting.back().cellCount;
        }
        const CellRange cells = waiting.back();
        waiting.pop_back();
        TubeBatch batch(kernels_, *grids_, cells, capacity_);
        std::uint32_t window = 0;
        if (bake(batch, cells, sums, window)) {
            counts_.peak = std::max<std::uint64_t>(counts_.peak, batch.nodeCount());
            counts_.refusedSplits += batch.refusedHalvings();
            counts_.splits += (batch.nodeCount() - cells.cellCount) / 2;
            batchCells = std::clamp(std::uint32_t(kFilling * capacity_ / batch.vertexCount() * cells.cellCount), 1u, kMostCells);
        } else {
            const std::uint32_t half = cells.cellCount / 2;
            const std::uint32_t firstDeposit = std::max(window, cells.firstDeposit);
            waiting.push_back({cells.firstCell + half, cells.cellCount - half, firstDeposit});
            waiting.push_back({cells.firstCell, half, firstDeposit});
        }
        if (progress) {
            progress(double(nextCell) / double(grids_->cellCount));
        }
    }
    counts_.fieldEvaluations = kernels_.fieldEvaluations();
    counts_.folds = kernels_.foldedCells();
}

void TubeBake::read(const DenseGrid<float>& opaque, BakedLight& light) const { sums_.read(settings_, opaque, light); }

} // namespace eikonal::bake

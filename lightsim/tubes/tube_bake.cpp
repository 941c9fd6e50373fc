#include "lightsim/tubes/tube_bake.h"

#include <algorithm>
#include <vector>

#include "common/interrupt.h"

namespace eikonal::bake {

namespace {

constexpr std::uint32_t kFirstBatch = 64;   // cells; later ones follow what these needed
constexpr std::uint32_t kMostCells = 4096;  // in a batch
constexpr double kFilling = 0.6;            // of the capacity that a batch is meant to need

} // namespace

TubeBake::TubeBake(const gpu::Context& context, const std::vector<std::string>& defines, const LaunchGrids& grids,
                   const BakeSettings& settings, const TubeSettings& tubeSettings, std::uint32_t capacity,
                   double finishedShare)
    : grids_(grids), capacity_(capacity), maxWindows_(settings.maxSteps / TUBE_STEPS + 1), finishedShare_(finishedShare),
      kernels_(context, defines, grids, settings, tubeSettings, capacity) {}

/// The method: propagate, refine, conform, deposit, until no light is left. False: the batch needs more rays than there is
/// room for, and `window` is the first that is not deposited.
bool TubeBake::bake(TubeBatch& batch, const CellRange& cells, const LightSums& sums, PatchCounts& counts,
                    std::uint32_t& window) {
    for (window = 0; window < maxWindows_; ++window) {
        throwIfInterrupted();
        batch.begin(window);
        batch.propagate();
        if (!batch.refine()) {
            return false;
        }
        batch.conform();
        if (window >= cells.firstDeposit) {
            batch.deposit(sums, counts);
        }
        if (batch.isFinished(finishedShare_)) {
            break;
        }
    }
    batch.tally();
    return true;
}

void TubeBake::propagate(int begin, int end, const LightSums& sums, PatchCounts& counts,
                         const std::function<void(double)>& progress) {
    kernels_.setSlab(begin, end);
    kernels_.clearLedger();
    std::vector<CellRange> waiting;
    std::uint32_t nextCell = 0;
    std::uint32_t batchCells = kFirstBatch;
    while (nextCell < grids_.cellCount || !waiting.empty()) {
        if (waiting.empty()) {
            waiting.push_back({nextCell, std::min(batchCells, grids_.cellCount - nextCell), 0});
            nextCell += waiting.back().cellCount;
        }
        const CellRange cells = waiting.back();
        waiting.pop_back();
        TubeBatch batch(kernels_, grids_, cells, capacity_);
        std::uint32_t window = 0;
        if (bake(batch, cells, sums, counts, window)) {
            counts.peak = std::max<std::uint64_t>(counts.peak, batch.nodeCount());
            counts.refusedSplits += batch.refusedHalvings();
            counts.splits += (batch.nodeCount() - cells.cellCount) / 2;
            batchCells = std::clamp(std::uint32_t(kFilling * capacity_ / batch.vertexCount() * cells.cellCount), 1u, kMostCells);
        } else {
            const std::uint32_t half = cells.cellCount / 2;
            const std::uint32_t firstDeposit = std::max(window, cells.firstDeposit);
            waiting.push_back({cells.firstCell + half, cells.cellCount - half, firstDeposit});
            waiting.push_back({cells.firstCell, half, firstDeposit});
        }
        if (progress) {
            progress(double(nextCell) / double(grids_.cellCount));
        }
    }
    counts.fieldEvaluations = kernels_.fieldEvaluations();
}

} // namespace eikonal::bake

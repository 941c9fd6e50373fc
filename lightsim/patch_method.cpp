#include "lightsim/patch_method.h"

#include "common/interrupt.h"

namespace eikonal::bake {

namespace {

// Rounds between two looks at the queue: few enough that a driver's watchdog and a person's Ctrl-C are answered soon.
constexpr int kRoundsPerLook = 16;

} // namespace

PatchMethod::PatchMethod(const gpu::Context& context, const MethodPlan& plan, const LaunchGrids& grids,
                         const BakeSettings& settings)
    : context_(context), defines_(plan.defines), settings_(settings), wavefront_(context, plan.defines, grids, settings),
      deposit_(makeDeposit(plan.accuracy.deposit, context, plan.defines, plan.fields.lattice, plan.blockBytes, plan.bands)) {}

void PatchMethod::setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) {
    settings_ = settings;
    wavefront_.setGrids(context, grids);
}

void PatchMethod::propagate(int begin, int end, const std::function<void(double)>& progress) {
    deposit_->clear();
    run(begin, end, [this] { deposit_->add(wavefront_); }, progress);
}

void PatchMethod::propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) {
    if (!intoLobes_) {
        intoLobes_.emplace(context_, withLobes(defines_));
    }
    run(bins.tile().slabBegin, bins.tile().slabEnd, [&] { intoLobes_->add(wavefront_, bins); }, progress);
}

void PatchMethod::run(int begin, int end, const std::function<void()>& deposit,
                      const std::function<void(double)>& progress) {
    settings_.slabBegin = begin;
    settings_.slabEnd = end;
    wavefront_.restart(settings_);
    for (QueueState state{}; !isFinished(state, settings_);) {
        for (int round = 0; round < kRoundsPerLook; ++round) {
            wavefront_.emit();
            wavefront_.propagate();
            deposit();
            wavefront_.refine();
        }
        state = wavefront_.state();
        throwIfInterrupted();
        if (progress) {
            progress(double(state.nextCell) / double(settings_.cellCount));
        }
    }
}

void PatchMethod::read(const DenseGrid<float>& opaque, BakedLight& light) const {
    deposit_->read(settings_, opaque, light);
}

PatchCounts PatchMethod::counts() const {
    const QueueState state = wavefront_.state();
    PatchCounts counts;
    counts.peak = state.peakLive;
    counts.steps = (std::uint64_t(state.stepsHigh) << 32) | state.stepsLow;
    counts.fieldEvaluations = (std::uint64_t(state.evaluationsHigh) << 32) | state.evaluationsLow;
    counts.splits = state.splits;
    counts.folds = state.folds;
    counts.refusedSplits = state.recordOverflow;
    return counts;
}

} // namespace eikonal::bake

#include "lightsim/wavefront.h"

#include <cstddef>
#include <numeric>

namespace eikonal::bake {

namespace {

std::vector<std::string> with(std::vector<std::string> defines, const char* extra) {
    defines.emplace_back(extra);
    return defines;
}

} // namespace

Wavefront::Wavefront(const gpu::Context& context, const std::vector<std::string>& defines, const LaunchGrids& grids,
                     const BakeSettings& settings)
    : capacity_(settings.capacity),
      patches_(context, std::size_t(capacity_) * sizeof(WavefrontPatch), "bake patches"),
      queue_(context, sizeof(QueueState) + POOL_LISTS * capacity_ * sizeof(std::uint32_t), "bake queue"),
      frames_(context, grids.frames.size() * sizeof(LaunchFrame), "bake launch frames"),
      records_(context, std::size_t(settings.recordCapacity) * sizeof(LaunchRecord), "bake launch records"),
      ledger_(context, LEDGER_ROWS * 3 * 2 * sizeof(std::uint32_t), "bake ledger"),
      settings_(context, sizeof(BakeSettings), "bake settings"),
      planEmission_(context, "lightsim/schedule.comp.glsl", with(defines, "SCHEDULE_EMIT")),
      emit_(context, "lightsim/emit.comp.glsl", defines),
      beginRound_(context, "lightsim/schedule.comp.glsl", defines),
      propagate_(context, "lightsim/propagate.comp.glsl", defines),
      refine_(context, "lightsim/refine.comp.glsl", defines),
      retire_(context, "lightsim/retire.comp.glsl", defines),
      split_(context, "lightsim/split.comp.glsl", defines) {
    frames_.upload(std::span<const LaunchFrame>(grids.frames));
}

void Wavefront::setGrids(const gpu::Context& context, const LaunchGrids& grids) {
    frames_ = gpu::Buffer(context, grids.frames.size() * sizeof(LaunchFrame), "bake launch frames");
    frames_.upload(std::span<const LaunchFrame>(grids.frames));
}

void Wavefront::restart(const BakeSettings& settings) {
    settings_.upload(settings);
    patches_.fill(0);
    ledger_.fill(0);
    QueueState state{};
    state.freeTail = state.freeTailAtStart = capacity_;
    std::vector<std::uint32_t> slots(capacity_);
    std::iota(slots.begin(), slots.end(), 0u);
    queue_.fill(0);
    queue_.upload(state);
    queue_.uploadBytes(sizeof(QueueState) + FREE_RING * capacity_ * sizeof(std::uint32_t), slots.data(),
                       slots.size() * sizeof(std::uint32_t));
}

void Wavefront::bindPool() const {
    patches_.bindStorage(BAKE_PATCHES_BINDING);
    queue_.bindStorage(BAKE_QUEUE_BINDING);
    settings_.bindUniform(BAKE_SETTINGS_BINDING);
}

void Wavefront::bindSources() const {
    bindPool();
    frames_.bindStorage(BAKE_FRAMES_BINDING);
    records_.bindStorage(BAKE_RECORDS_BINDING);
    ledger_.bindStorage(BAKE_LEDGER_BINDING);
}

void Wavefront::emit() const {
    bindSources();
    planEmission_.dispatch({1, 1, 1});
    emit_.dispatchIndirect(queue_, offsetof(QueueState, emitGroups));
    beginRound_.dispatch({1, 1, 1});
}

void Wavefront::propagate() const {
    bindPool();
    propagate_.dispatchIndirect(queue_, offsetof(QueueState, particleGroups));
}

void Wavefront::refine() const {
    bindSources();
    dispatchOverPatches(refine_);
    retire_.dispatchIndirect(queue_, offsetof(QueueState, retireGroups));
    split_.dispatchIndirect(queue_, offsetof(QueueState, splitGroups));
}

void Wavefront::dispatchOverPatches(const gpu::Kernel& kernel) const {
    kernel.dispatchIndirect(queue_, offsetof(QueueState, patchGroups));
}

void Wavefront::dispatchOverListedCorners(const gpu::Kernel& kernel) const {
    kernel.dispatchIndirect(queue_, offsetof(QueueState, cornersGroups));
}

QueueState Wavefront::state() const { return queue_.download<QueueState>(1).front(); }

std::vector<WavefrontPatch> Wavefront::livePatches() const {
    const QueueState current = state();
    std::vector<std::uint32_t> slots(current.nextLiveCount);
    queue_.downloadBytes(sizeof(QueueState) + (1 - current.parity) * capacity_ * sizeof(std::uint32_t), slots.data(),
                         slots.size() * sizeof(std::uint32_t));
    std::vector<WavefrontPatch> live(slots.size());
    for (std::size_t i = 0; i < live.size(); ++i) {
        patches_.downloadBytes(slots[i] * sizeof(WavefrontPatch), &live[i], sizeof(WavefrontPatch));
    }
    return live;
}

std::vector<double> Wavefront::ledger() const {
    const auto words = ledger_.download<std::uint32_t>(LEDGER_ROWS * 3 * 2);
    std::vector<double> rows(LEDGER_ROWS * 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = fixedPointValue(words[2 * i], words[2 * i + 1]);
    }
    return rows;
}

std::size_t Wavefront::bytes() const {
    return patches_.bytes() + queue_.bytes() + frames_.bytes() + records_.bytes() + ledger_.bytes() + settings_.bytes();
}

} // namespace eikonal::bake

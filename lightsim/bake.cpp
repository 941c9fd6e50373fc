#include "lightsim/bake.h"

#include <chrono>

#include "common/gpu_fields.h"
#include "common/interrupt.h"
#include "lightsim/deposit.h"
#include "lightsim/emit.h"
#include "lightsim/ledger.h"
#include "lightsim/settings.h"
#include "lightsim/wavefront.h"

namespace eikonal {

namespace {

using Clock = std::chrono::steady_clock;

// Rounds between two looks at the queue: few enough that a driver's watchdog and a person's Ctrl-C are answered soon.
constexpr int kRoundsPerLook = 16;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<std::string> definesOf(const GpuFields& gpuFields, int bands) {
    std::vector<std::string> defines = gpuFields.defines();
    defines.push_back("BANDS " + std::to_string(bands));
    return defines;
}

std::size_t blockBytesOf(const gpu::Context& context, const BakeOptions& options) {
    return options.maxBlockBytes > 0 ? options.maxBlockBytes : context.limits().maxStorageBlockBytes;
}

/// The method: emit, propagate, deposit, refine, until no light is left.
void propagateWavefront(const bake::Wavefront& wavefront, const bake::Deposit& deposit,
                        const bake::BakeSettings& settings, const BakeOptions& options) {
    for (;;) {
        for (int round = 0; round < kRoundsPerLook; ++round) {
            wavefront.emit();
            wavefront.propagate();
            deposit.add(wavefront);
            wavefront.refine();
        }
        const bake::QueueState state = wavefront.state();
        throwIfInterrupted();
        if (options.progress) {
            options.progress(double(state.nextCell) / double(settings.cellCount));
        }
        if (isFinished(state, settings)) {
            return;
        }
    }
}

PatchCounts countsOf(const bake::QueueState& state) {
    PatchCounts counts;
    counts.peak = state.peakLive;
    counts.steps = (std::uint64_t(state.stepsHigh) << 32) | state.stepsLow;
    counts.fieldEvaluations = (std::uint64_t(state.evaluationsHigh) << 32) | state.evaluationsLow;
    counts.splits = state.splits;
    counts.folds = state.folds;
    counts.refusedSplits = state.recordOverflow;
    return counts;
}

BakedLight darkness(const Lattice& lattice) {
    return {lattice, {lattice.size, glm::vec3(0.0f)}, {lattice.size, glm::vec3(0.0f)}};
}

/// Propagates the light once per slab of voxel layers, so that the sums never need more than one block each.
void bakeSlabs(bake::Wavefront& wavefront, bake::Deposit& deposit, const Fields& fields, bake::BakeSettings settings,
               const BakeOptions& options, BakeResult& result) {
    const int depth = fields.lattice.size.z;
    result.statistics.memoryBytes += wavefront.bytes() + deposit.bytes();
    for (int begin = 0; begin < depth; begin += deposit.layers()) {
        const auto start = Clock::now();
        settings.slabBegin = begin;
        settings.slabEnd = std::min(begin + deposit.layers(), depth);
        wavefront.restart(settings);
        deposit.clear();
        propagateWavefront(wavefront, deposit, settings, options);
        result.statistics.seconds.propagate += secondsSince(start);
        const auto readStart = Clock::now();
        deposit.read(settings, fields.opaque, result.light);
        result.statistics.seconds.read += secondsSince(readStart);
    }
    result.statistics.patches = countsOf(wavefront.state());
    bake::readLedger(wavefront.ledger(), 1.0 / double(settings.ledgerScale), result.statistics.energy);
}

} // namespace

BakeResult bakeScene(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                     const BakeOptions& options) {
    const auto start = Clock::now();
    BakeResult result{darkness(fields.lattice), {}};
    result.statistics.device = context.rendererName();
    const bake::Criteria criteria = bake::criteriaOf(scene.accuracy, fields);
    const bake::LaunchGrids grids =
        bake::launchGrids(scene.lights, fields.lattice, criteria.maxSide, criteria.splitShare);
    result.statistics.energy.emitted = grids.emitted;
    if (grids.strongestPower > 0.0) {
        const GpuFields gpuFields(context, fields, effects);
        gpuFields.bind();
        for (const auto& [name, bytes] : gpuFields.textures()) {
            result.statistics.memoryBytes += bytes;
        }
        const int bands = bake::bandsOf(scene, fields, effects);
        result.statistics.seconds.upload = secondsSince(start);
        const std::vector<std::string> defines = definesOf(gpuFields, bands);
        const bake::BakeSettings settings = bake::settingsOf(criteria, grids, fields, options);
        bake::Wavefront wavefront(context, defines, grids, settings);
        const auto deposit = bake::makeDeposit(scene.accuracy.deposit, context, defines, fields.lattice,
                                               blockBytesOf(context, options), bands);
        bakeSlabs(wavefront, *deposit, fields, settings, options, result);
        bake::integrateDeposits(fields, result.light, result.statistics.energy);
    }
    context.throwIfError();
    result.statistics.seconds.total = secondsSince(start);
    return result;
}

} // namespace eikonal

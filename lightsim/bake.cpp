#include "lightsim/bake.h"

#include <chrono>

#include "common/gpu_fields.h"
#include "common/interrupt.h"
#include "lightsim/deposit.h"
#include "lightsim/emit.h"
#include "lightsim/ledger.h"
#include "lightsim/settings.h"
#include "lightsim/tubes/tube_bake.h"
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

/// The method of 2007 rather than ray tubes.
bool usesPatches(const Accuracy& accuracy) { return accuracy.deposit == Deposit::kSplat; }

bool isFinished(const bake::QueueState& state, const bake::BakeSettings& settings) {
    return state.liveCount == 0 && state.nextLiveCount == 0 && state.recordCount == 0 &&
           state.nextCell >= settings.cellCount;
}

/// The method of 2007: emit, propagate, deposit, refine, until no light is left.
void propagateWavefront(const bake::Wavefront& wavefront, const bake::Deposit& deposit, const bake::LightSums& sums,
                        const bake::BakeSettings& settings, const BakeOptions& options) {
    for (;;) {
        for (int round = 0; round < kRoundsPerLook; ++round) {
            wavefront.emit();
            wavefront.propagate();
            deposit.add(wavefront, sums);
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

/// What a bake needs besides the context.
struct Plan {
    const Fields& fields;
    const Accuracy& accuracy;
    std::vector<std::string> defines;
    int bands;
    const bake::LaunchGrids& grids;
    bake::Criteria criteria;
    bake::BakeSettings settings;
    const BakeOptions& options;
};

/// Adds the light to the layers [begin, end) of the sums.
using Propagate = std::function<void(int begin, int end, const bake::LightSums& sums)>;

/// Propagates the light once per slab of voxel layers, so that the sums never need more than one block each.
void bakeSlabs(const gpu::Context& context, const Plan& plan, const Propagate& propagate, BakeResult& result) {
    const Lattice& lattice = plan.fields.lattice;
    const std::size_t blockBytes =
        plan.options.maxBlockBytes > 0 ? plan.options.maxBlockBytes : context.limits().maxStorageBlockBytes;
    const int layers = bake::layersPerSlab(lattice, blockBytes);
    bake::LightSums sums(context, lattice, layers, plan.bands);
    result.statistics.memoryBytes += sums.bytes();
    const double irradianceUnit = 1.0 / (double(plan.settings.depositScale) * lattice.voxel * lattice.voxel);
    for (int begin = 0; begin < lattice.size.z; begin += layers) {
        const auto start = Clock::now();
        const int end = std::min(begin + layers, lattice.size.z);
        sums.clear();
        propagate(begin, end, sums);
        result.statistics.seconds.propagate += secondsSince(start);
        const auto readStart = Clock::now();
        sums.read(begin, end, irradianceUnit, plan.fields.opaque, result.light);
        result.statistics.seconds.read += secondsSince(readStart);
    }
}

void bakeByPatches(const gpu::Context& context, const Plan& plan, BakeResult& result) {
    bake::Wavefront wavefront(context, plan.defines, plan.grids, plan.settings);
    const bake::Deposit deposit(context, plan.defines);
    result.statistics.memoryBytes += wavefront.bytes();
    bakeSlabs(context, plan, [&](int begin, int end, const bake::LightSums& sums) {
        bake::BakeSettings settings = plan.settings;
        settings.slabBegin = begin;
        settings.slabEnd = end;
        wavefront.restart(settings);
        propagateWavefront(wavefront, deposit, sums, settings, plan.options);
    }, result);
    result.statistics.patches = countsOf(wavefront.state());
    bake::readLedger(wavefront.ledger(), 1.0 / double(plan.settings.ledgerScale), result.statistics.energy);
}

void bakeByTubes(const gpu::Context& context, const Plan& plan, BakeResult& result) {
    bake::TubeBake tubes(context, plan.defines, plan.grids, plan.settings,
                         bake::tubeSettingsOf(plan.accuracy, plan.grids, plan.fields), plan.options.tubeVertices, plan.criteria.cullShare);
    result.statistics.memoryBytes += tubes.bytes();
    bakeSlabs(context, plan, [&](int begin, int end, const bake::LightSums& sums) {
        tubes.propagate(begin, end, sums, result.statistics.patches, plan.options.progress);
    }, result);
    bake::readLedger(tubes.ledger(), 1.0 / double(plan.settings.ledgerScale), result.statistics.energy);
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
        const Plan plan{fields, scene.accuracy, definesOf(gpuFields, bands), bands, grids, criteria,
                        bake::settingsOf(criteria, grids, fields, options), options};
        result.statistics.seconds.upload = secondsSince(start);
        (usesPatches(scene.accuracy) ? bakeByPatches : bakeByTubes)(context, plan, result);
        bake::integrateDeposits(fields, result.light, result.statistics.energy);
    }
    context.throwIfError();
    result.statistics.seconds.total = secondsSince(start);
    return result;
}

} // namespace eikonal

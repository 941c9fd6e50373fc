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

bool isFinished(const bake::QueueState& state, const bake::BakeSettings& settings) {
    return state.liveCount == 0 && state.nextLiveCount == 0 && state.recordCount == 0 &&
           state.nextCell >= settings.cellCount;
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

} // namespace

/// What stays on the device from one bake to the next.
struct LightSimulator::Device {
    GpuFields fields;
    int bands;
    int layers;  ///< of voxels in a slab
    bake::Wavefront wavefront;
    bake::Deposit deposit;

    Device(const gpu::Context& context, const Fields& sceneFields, const EffectSet& effects, int bandCount, int slabLayers,
           const bake::LaunchGrids& grids, const bake::BakeSettings& settings)
        : fields(context, sceneFields, effects), bands(bandCount), layers(slabLayers),
          wavefront(context, definesOf(fields, bands), grids, settings),
          deposit(context, definesOf(fields, bands), sceneFields.lattice, layers, bands) {}

    std::size_t bytes() const {
        std::size_t sum = wavefront.bytes() + deposit.bytes();
        for (const auto& [name, textureBytes] : fields.textures()) {
            sum += textureBytes;
        }
        return sum;
    }

    /// Propagates the light once per slab of voxel layers, so that the sums never need more than one block each.
    void bakeSlabs(const Fields& sceneFields, bake::BakeSettings settings, const BakeOptions& options,
                   BakeResult& result) {
        const Lattice& lattice = sceneFields.lattice;
        const double irradianceUnit = 1.0 / (double(settings.depositScale) * lattice.voxel * lattice.voxel);
        for (int begin = 0; begin < lattice.size.z; begin += layers) {
            const auto start = Clock::now();
            settings.slabBegin = begin;
            settings.slabEnd = std::min(begin + layers, lattice.size.z);
            wavefront.restart(settings);
            deposit.clear();
            propagateWavefront(wavefront, deposit, settings, options);
            result.statistics.seconds.propagate += secondsSince(start);
            const auto readStart = Clock::now();
            deposit.read(begin, settings.slabEnd, irradianceUnit, sceneFields.opaque, result.light);
            result.statistics.seconds.read += secondsSince(readStart);
        }
        result.statistics.patches = countsOf(wavefront.state());
        bake::readLedger(wavefront.ledger(), 1.0 / double(settings.ledgerScale), result.statistics.energy);
    }
};

LightSimulator::LightSimulator(const gpu::Context& context, const Scene& scene, const Fields& fields,
                               const EffectSet& effects, const BakeOptions& options)
    : context_(context), fields_(fields), effects_(effects), options_(options),
      criteria_(std::make_unique<bake::Criteria>(bake::criteriaOf(scene.accuracy, fields))) {}

LightSimulator::~LightSimulator() = default;

LightSimulator::Device& LightSimulator::deviceFor(int bands, const bake::LaunchGrids& grids,
                                                  const bake::BakeSettings& settings) {
    if (device_ && device_->bands == bands) {
        device_->wavefront.setGrids(context_, grids);
    } else {
        const std::size_t blockBytes =
            options_.maxBlockBytes > 0 ? options_.maxBlockBytes : context_.limits().maxStorageBlockBytes;
        const int layers = bake::layersPerSlab(fields_.lattice, blockBytes);
        device_.reset();  // the old one's memory before the new one's
        device_ = std::make_unique<Device>(context_, fields_, effects_, bands, layers, grids, settings);
    }
    device_->fields.bind();
    return *device_;
}

BakeResult LightSimulator::bake(const LightSet& lights) {
    const auto start = Clock::now();
    BakeResult result{darkness(fields_.lattice), {}, {}};
    result.statistics.device = context_.rendererName();
    const bake::LaunchGrids grids =
        bake::launchGrids(lights, fields_.lattice, criteria_->maxSide, criteria_->splitShare);
    result.statistics.energy.emitted = grids.emitted;
    if (grids.strongestPower > 0.0) {
        const bake::BakeSettings settings = bake::settingsOf(*criteria_, grids, fields_, options_);
        Device& device = deviceFor(bake::bandsOf(lights, fields_, effects_), grids, settings);
        result.statistics.memoryBytes = device.bytes();
        result.statistics.seconds.upload = secondsSince(start);
        device.bakeSlabs(fields_, settings, options_, result);
        bake::integrateDeposits(fields_, result.light, result.statistics.energy);
    }
    context_.throwIfError();
    result.statistics.seconds.total = secondsSince(start);
    return result;
}

BakeResult bakeScene(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                     const BakeOptions& options) {
    LightSimulator simulator(context, scene, fields, effects, options);
    return simulator.bake(lightsAt(lightsOf(scene, effects), 0.0));
}

} // namespace eikonal

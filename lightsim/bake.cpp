#include "lightsim/bake.h"

#include <algorithm>
#include <chrono>

#include <fmt/core.h>

#include "common/accuracy.h"
#include "common/error.h"
#include "common/gpu_fields.h"
#include "common/spectral_fields.h"
#include "lightsim/emit.h"
#include "lightsim/ledger.h"
#include "lightsim/light_method.h"
#include "lightsim/light_sums.h"
#include "lightsim/lobes.h"
#include "lightsim/power_unit.h"
#include "lightsim/settings.h"
#include "lightsim/spectral_bake.h"

namespace eikonal {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<std::string> definesOf(const GpuFields& gpuFields, int bands) {
    std::vector<std::string> defines = gpuFields.defines();
    defines.push_back("BANDS " + std::to_string(bands));
    return defines;
}

BakedLight darkness(const Lattice& lattice, bool hasEikonal) {
    BakedLight dark{lattice, {lattice.size, glm::vec3(0.0f)}, {lattice.size, glm::vec3(0.0f)}};
    if (hasEikonal) {
        dark.eikonal = DenseGrid<float>(lattice.size, kUnreached);
    }
    return dark;
}

/// The options of one of several equal parts of the work.
BakeOptions asPart(const BakeOptions& options, std::size_t part, std::size_t parts) {
    BakeOptions result = options;
    if (options.progress) {
        result.progress = [=, progress = options.progress](double fraction) {
            progress((double(part) + fraction) / double(parts));
        };
    }
    return result;
}

/// Throws badInput for an eikonal by patches: rays alone carry it.
void requireTubesForEikonal(const Scene& scene, const BakeOptions& options) {
    if (options.eikonal && bake::usesPatches(scene.accuracy)) {
        throw badInput(fmt::format("{}: accuracy.deposit: expected 'auto' or 'cells' for an eikonal, found '{}'",
                                   describe(scene.placeOf({"accuracy.deposit"})),
                                   scene.accuracy.deposit == Deposit::kPeak ? "peak" : "splat"));
    }
}

} // namespace

/// What stays on the device from one bake to the next.
struct LightSimulator::Device {
    GpuFields fields;
    int bands;
    std::unique_ptr<bake::LightMethod> method;

    std::size_t bytes() const {
        std::size_t sum = method->bytes();
        for (const auto& [name, textureBytes] : fields.textures()) {
            sum += textureBytes;
        }
        return sum;
    }

    /// Propagates the light once per slab of voxel layers, so that the sums never need more than one block each.
    void bakeSlabs(const Fields& sceneFields, const BakeOptions& options, BakeResult& result) {
        const int depth = sceneFields.lattice.size.z;
        for (int begin = 0; begin < depth; begin += method->layers()) {
            const auto start = Clock::now();
            method->propagate(begin, std::min(begin + method->layers(), depth), options.progress);
            result.statistics.seconds.propagate += secondsSince(start);
            const auto readStart = Clock::now();
            method->read(sceneFields.opaque, result.light);
            result.statistics.seconds.read += secondsSince(readStart);
        }
        result.statistics.patches = method->counts();
    }

    void bakeLobes(const gpu::Context& context, const bake::LobeCriterion& criterion, const bake::LobePlan& plan,
                   const BakeOptions& options, BakeResult& result) {
        const auto start = Clock::now();
        result.light.lobes = bake::lobesOf(context, *method, criterion, plan, result.light, options.progress);
        result.statistics.lobeVoxels = result.light.lobes.voxels.size();
        result.statistics.seconds.lobes = secondsSince(start);
    }
};

LightSimulator::LightSimulator(const gpu::Context& context, const Scene& scene, const Fields& fields,
                               const EffectSet& effects, const BakeOptions& options)
    : context_(context), accuracy_(scene.accuracy), fields_(fields), effects_(effects), options_(options),
      interpolation_(bake::interpolationOfLight(scene.accuracy, fields.ior)),
      lobeCriterion_(std::make_unique<bake::LobeCriterion>(scene.accuracy, fields, effects)) {
    requireTubesForEikonal(scene, options);
    bake::requireKnownByBand(scene, effects, options);
}

LightSimulator::~LightSimulator() = default;

std::size_t LightSimulator::blockBytes() const {
    return options_.maxBlockBytes > 0 ? options_.maxBlockBytes : context_.limits().maxStorageBlockBytes;
}

LightSimulator::Device& LightSimulator::deviceFor(int bands, const Fields& fields, const bake::LaunchGrids& grids,
                                                  const bake::BakeSettings& settings) {
    const EffectSet effects = effects_.without(Effect::kDispersion);  // the fields are those of one wavelength
    if (!device_ || device_->bands != bands) {
        device_.reset();  // the old one's memory before the new one's
        device_ = std::make_unique<Device>(Device{GpuFields(context_, fields, effects, interpolation_), bands, nullptr});
        device_->method =
            bake::makeMethod(context_, {fields_, accuracy_, definesOf(device_->fields, bands), bands, blockBytes()}, options_,
                             grids, settings);
    } else if (&fields != &fields_) {
        device_->fields = GpuFields(context_, fields, effects, interpolation_);
    }
    if (&fields != &fields_) {
        device_->method->setFields(context_, fields);
    }
    device_->fields.bind();
    device_->method->setLights(context_, grids, settings);
    return *device_;
}

BakeResult LightSimulator::bake(const LightSet& lights) {
    const std::vector<SpectralBand> bands = spectralBandsOf(accuracy_, effects_);
    if (bands.empty()) {
        return bakeIn(fields_, lights, options_);
    }
    return bake::bakeSpectrum(fields_, lights, bands,
                              [&](const Fields& fields, const LightSet& ofBand, std::size_t band) {
                                  return bakeIn(fields, ofBand, asPart(options_, band, bands.size()));
                              });
}

BakeResult LightSimulator::bakeIn(const Fields& fields, const LightSet& sceneLights, const BakeOptions& options) {
    const auto start = Clock::now();
    const bool isGreyMatter = bake::isGreyMatter(fields, effects_, accuracy_);
    const glm::dvec3 powerUnit =
        isGreyMatter ? bake::colouredUnitOf(sceneLights) : glm::dvec3(bake::powerUnitOf(sceneLights));
    const LightSet lights = bake::inPowerUnits(sceneLights, powerUnit);
    const int bands = isGreyMatter && bake::isGreyLight(lights) ? 1 : 3;
    BakeResult result{darkness(fields.lattice, options.eikonal), {}, {}};
    result.statistics.device = context_.rendererName();
    result.statistics.interpolation = interpolation_;
    const bake::Criteria criteria = bake::criteriaOf(accuracy_, fields, options.meshScale);
    const bake::LaunchGrids grids = bake::launchGrids(lights, fields.lattice, criteria);
    result.statistics.energy.emitted = grids.emitted;
    if (grids.strongestPower > 0.0) {
        const bake::BakeSettings settings = bake::settingsOf(criteria, grids, fields, options);
        Device& device = deviceFor(bands, fields, grids, settings);
        result.statistics.seconds.upload = secondsSince(start);
        device.bakeSlabs(fields, options, result);
        device.bakeLobes(context_, *lobeCriterion_,
                         {fields, bake::depositUnit(settings, fields.lattice), device.bands, blockBytes()}, options, result);
        result.statistics.memoryBytes = device.bytes();
        bake::readLedger(device.method->ledger(), 1.0 / double(settings.ledgerScale), result.statistics.energy);
        bake::integrateDeposits(fields, bake::usesPatches(accuracy_) ? bake::VoxelMean::kHat : bake::VoxelMean::kCube, result.light,
                                result.statistics.energy);
    }
    context_.throwIfError();
    bake::leavePowerUnits(result, powerUnit);
    result.statistics.seconds.total = secondsSince(start);
    return result;
}

BakeResult bakeScene(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                     const BakeOptions& options) {
    LightSimulator simulator(context, scene, fields, effects, options);
    return simulator.bake(lightsAt(lightsOf(scene, effects), 0.0));
}

} // namespace eikonal

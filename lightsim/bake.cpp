#include "lightsim/bake.h"

#include <algorithm>
#include <chrono>

#include "common/gpu_fields.h"
#include "lightsim/emit.h"
#include "lightsim/ledger.h"
#include "lightsim/light_method.h"
#include "lightsim/settings.h"

namespace eikonal {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<std::string> definesOf(const GpuFields& gpuFields, int bands) {
    std::vector<std::string> defines = gpuFields.defines();
    defines.push_back("BANDS " + std::to_string(bands));
    return defines;
}

BakedLight darkness(const Lattice& lattice) {
    return {lattice, {lattice.size, glm::vec3(0.0f)}, {lattice.size, glm::vec3(0.0f)}};
}

/// Propagates the light once per slab of voxel layers, so that the sums never need more than one block each.
void bakeSlabs(bake::LightMethod& method, const Fields& fields, const BakeOptions& options, BakeResult& result) {
    const int depth = fields.lattice.size.z;
    for (int begin = 0; begin < depth; begin += method.layers()) {
        const auto start = Clock::now();
        method.propagate(begin, std::min(begin + method.layers(), depth), options.progress);
        result.statistics.seconds.propagate += secondsSince(start);
        const auto readStart = Clock::now();
        method.read(fields.opaque, result.light);
        result.statistics.seconds.read += secondsSince(readStart);
    }
    result.statistics.patches = method.counts();
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
        const int bands = bake::bandsOf(scene, fields, effects);
        const std::size_t blockBytes =
            options.maxBlockBytes > 0 ? options.maxBlockBytes : context.limits().maxStorageBlockBytes;
        const bake::BakeSettings settings = bake::settingsOf(criteria, grids, fields, options);
        const auto method = bake::makeMethod(
            context, {fields, scene.accuracy, definesOf(gpuFields, bands), bands, blockBytes}, options, grids, settings);
        result.statistics.seconds.upload = secondsSince(start);
        bakeSlabs(*method, fields, options, result);
        bake::readLedger(method->ledger(), 1.0 / double(settings.ledgerScale), result.statistics.energy);
        bake::integrateDeposits(fields, result.light, result.statistics.energy);
        for (const auto& [name, bytes] : gpuFields.textures()) {
            result.statistics.memoryBytes += bytes;
        }
        result.statistics.memoryBytes += method->bytes();
    }
    context.throwIfError();
    result.statistics.seconds.total = secondsSince(start);
    return result;
}

} // namespace eikonal

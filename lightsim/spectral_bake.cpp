#include "lightsim/spectral_bake.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/error.h"
#include "common/spectral_fields.h"
#include "lightsim/power_unit.h"

namespace eikonal::bake {

namespace {

/// The lights with what they have in one channel in all three.
LightSet lightsOfBand(LightSet lights, int channel) {
    forEachStrength(lights, [channel](glm::dvec3& strength) { strength = glm::dvec3(strength[channel]); });
    return lights;
}

DenseGrid<float> firstComponent(const DenseGrid<glm::vec3>& grid) {
    DenseGrid<float> result(grid.size, 0.0f);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        result.values[i] = grid.values[i].x;
    }
    return result;
}

/// Adds a band to the sums; the direction of `sum` is its flux until all bands are in.
void addBand(BakeResult& sum, DenseGrid<float>& total, BakeResult&& one, const SpectralBand& band, bool keepGrid) {
    DenseGrid<float> irradiance = firstComponent(one.light.irradiance);
    for (std::size_t i = 0; i < irradiance.values.size(); ++i) {
        const float value = irradiance.values[i];
        sum.light.irradiance.values[i] += glm::vec3(band.toRgb * double(value));
        sum.light.lightDirection.values[i] += one.light.lightDirection.values[i] * value;
        total.values[i] += value;
    }
    one.statistics.bands = {{band.wavelengthNm(), one.statistics.energy}};
    one.statistics.energy = one.statistics.energy.ofBand(band.toRgb);
    sum.statistics.addRun(one.statistics);
    if (keepGrid) {
        sum.light.bands.push_back({band.wavelengthNm(), std::move(irradiance)});
    }
}

} // namespace

void requireKnownByBand(const Scene& scene, const EffectSet& effects, const BakeOptions& options) {
    if (!effects.has(Effect::kDispersion)) {
        return;
    }
    if (scene.accuracy.directional == Directional::kLobes) {
        throw badInput(fmt::format("{}: accuracy.directional: expected 'auto' or 'mean' where something disperses, found "
                                   "'lobes'", describe(scene.placeOf({"accuracy.directional"}))));
    }
    if (options.eikonal) {
        throw badInput(fmt::format("{}: cauchy_b: expected 0 for an eikonal, which is that of one wavelength, found a scene "
                                   "where something disperses", scene.source));
    }
}

BakeResult bakeSpectrum(const Fields& fields, const LightSet& lights, const std::vector<SpectralBand>& bands,
                        const BandRun& run) {
    const DenseGrid<glm::vec3> nothing(fields.lattice.size, glm::vec3(0.0f));
    BakeResult result{{fields.lattice, nothing, nothing}, {}, {}};
    DenseGrid<float> total(fields.lattice.size, 0.0f);
    for (std::size_t band = 0; band < bands.size(); ++band) {
        BakeResult one = run(fieldsOfBand(fields, bands[band]), lightsOfBand(lights, bands[band].channel), band);
        addBand(result, total, std::move(one), bands[band], bands.size() > 3);
    }
    for (std::size_t i = 0; i < total.values.size(); ++i) {
        glm::vec3& direction = result.light.lightDirection.values[i];
        direction = total.values[i] > 0.0f ? direction / std::max(total.values[i], glm::length(direction)) : glm::vec3(0.0f);
    }
    return result;
}

} // namespace eikonal::bake

#include "lightsim/per_light.h"

#include "lightsim/lobes.h"

namespace eikonal {

namespace {

/// Irradiance of a voxel, all bands.
double overBandsAt(const BakedLight& light, std::size_t voxel) {
    if (light.bands.empty()) {
        return overBands(light.irradiance.values[voxel]);
    }
    double sum = 0.0;
    for (const BandIrradiance& band : light.bands) {
        sum += band.irradiance.values[voxel];
    }
    return sum;
}

glm::dvec3 fluxAt(const BakedLight& light, std::size_t voxel) {
    return glm::dvec3(light.lightDirection.values[voxel]) * overBandsAt(light, voxel);
}

/// Irradiances add; light directions by their flux, which is the direction times the irradiance of all bands.
void addLight(BakedLight& sum, const BakedLight& more) {
    for (std::size_t i = 0; i < sum.irradiance.values.size(); ++i) {
        const glm::dvec3 flux = fluxAt(sum, i) + fluxAt(more, i);
        sum.irradiance.values[i] += more.irradiance.values[i];
        for (std::size_t band = 0; band < sum.bands.size(); ++band) {
            sum.bands[band].irradiance.values[i] += more.bands[band].irradiance.values[i];
        }
        const double total = overBandsAt(sum, i);
        sum.lightDirection.values[i] = total > 0.0 ? glm::vec3(flux / total) : glm::vec3(0.0f);
    }
}

/// The light that comes first counts.
void addEikonal(DenseGrid<float>& least, const DenseGrid<float>& more) {
    for (std::size_t i = 0; i < least.values.size(); ++i) {
        const float path = more.values[i];
        if (path != kUnreached && (least.values[i] == kUnreached || path < least.values[i])) {
            least.values[i] = path;
        }
    }
}

} // namespace

BakeResult bakePerLight(LightSimulator& simulator, const LightSet& lights) {
    BakeResult sum = simulator.bake({});  // dark
    for (const NamedLightSet& single : singleLights(lights)) {
        BakeResult one = simulator.bake(single.lights);
        addLight(sum.light, one.light);
        addEikonal(sum.light.eikonal, one.light.eikonal);
        sum.statistics.addRun(one.statistics);
        sum.parts.push_back({single.name, std::move(one.light)});
    }
    sum.light.lobes = bake::summedLobes(simulator.lobeCriterion(), sum.parts, sum.light);
    sum.statistics.lobeVoxels = sum.light.lobes.voxels.size();
    return sum;
}

} // namespace eikonal

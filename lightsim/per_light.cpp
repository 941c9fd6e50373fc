#include "lightsim/per_light.h"

#include <algorithm>

#include "lightsim/lobes.h"

namespace eikonal {

namespace {

/// Irradiances add; light directions by their flux, which is the direction times the irradiance of all bands.
void addLight(BakedLight& sum, const BakedLight& more) {
    for (std::size_t i = 0; i < sum.irradiance.values.size(); ++i) {
        glm::vec3& irradiance = sum.irradiance.values[i];
        glm::vec3& direction = sum.lightDirection.values[i];
        const glm::dvec3 flux = glm::dvec3(direction) * overBands(irradiance) +
                                glm::dvec3(more.lightDirection.values[i]) * overBands(more.irradiance.values[i]);
        irradiance += more.irradiance.values[i];
        const double total = overBands(irradiance);
        direction = total > 0.0 ? glm::vec3(flux / total) : glm::vec3(0.0f);
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

void addStatistics(BakeStatistics& sum, const BakeStatistics& more) {
    sum.seconds.upload += more.seconds.upload;
    sum.seconds.propagate += more.seconds.propagate;
    sum.seconds.lobes += more.seconds.lobes;
    sum.seconds.read += more.seconds.read;
    sum.seconds.total += more.seconds.total;
    sum.patches.peak = std::max(sum.patches.peak, more.patches.peak);
    sum.patches.steps += more.patches.steps;
    sum.patches.fieldEvaluations += more.patches.fieldEvaluations;
    sum.patches.splits += more.patches.splits;
    sum.patches.folds += more.patches.folds;
    sum.patches.refusedSplits += more.patches.refusedSplits;
    sum.energy += more.energy;
    sum.memoryBytes = std::max(sum.memoryBytes, more.memoryBytes);
}

} // namespace

BakeResult bakePerLight(LightSimulator& simulator, const LightSet& lights) {
    BakeResult sum = simulator.bake({});  // dark
    for (const NamedLightSet& single : singleLights(lights)) {
        BakeResult one = simulator.bake(single.lights);
        addLight(sum.light, one.light);
        addEikonal(sum.light.eikonal, one.light.eikonal);
        addStatistics(sum.statistics, one.statistics);
        sum.parts.push_back({single.name, std::move(one.light)});
    }
    sum.light.lobes = bake::summedLobes(simulator.lobeCriterion(), sum.parts, sum.light);
    sum.statistics.lobeVoxels = sum.light.lobes.voxels.size();
    return sum;
}

} // namespace eikonal

#include "lightsim/power_unit.h"

#include <algorithm>
#include <cmath>

namespace eikonal::bake {

double powerUnitOf(const LightSet& lights) {
    double strongest = 0.0;
    LightSet copy = lights;
    forEachStrength(copy, [&](const glm::dvec3& strength) {
        strongest = std::max({strongest, strength.r, strength.g, strength.b});
    });
    return strongest > 0.0 ? std::exp2(std::floor(std::log2(strongest))) : 1.0;
}

LightSet inPowerUnits(LightSet lights, double unit) {
    forEachStrength(lights, [unit](glm::dvec3& strength) { strength /= unit; });
    return lights;
}

void leavePowerUnits(BakeResult& result, double unit) {
    const float factor = float(unit);
    for (glm::vec3& irradiance : result.light.irradiance.values) {
        irradiance *= factor;
    }
    for (VoxelLobes& row : result.light.lobes.rows) {
        for (LightLobe& lobe : row) {
            lobe.irradiance *= factor;
        }
    }
    result.statistics.energy = result.statistics.energy * unit;
}

} // namespace eikonal::bake

#include "lightsim/power_unit.h"

#include <cmath>

namespace eikonal::bake {

namespace {

int brightestBand(const glm::dvec3& strength) {
    return strength.r >= strength.g && strength.r >= strength.b ? 0 : strength.g >= strength.b ? 1 : 2;
}

/// The strongest in its brightest band.
glm::dvec3 strongestOf(const LightSet& lights) {
    glm::dvec3 strongest(0.0);
    LightSet copy = lights;
    forEachStrength(copy, [&](const glm::dvec3& strength) {
        if (strength[brightestBand(strength)] > strongest[brightestBand(strongest)]) {
            strongest = strength;
        }
    });
    return strongest;
}

/// Whether all lights are multiples of one, to rounding.
bool haveColour(const LightSet& lights, const glm::dvec3& one) {
    constexpr double kRounding = 1e-12;
    const int band = brightestBand(one);
    bool same = true;
    LightSet copy = lights;
    forEachStrength(copy, [&](const glm::dvec3& strength) {
        const glm::dvec3 expected = one * (strength[band] / one[band]);
        same = same && glm::all(glm::lessThanEqual(glm::abs(strength - expected), glm::dvec3(kRounding * strength[band])));
    });
    return same;
}

bool isColoured(const glm::dvec3& unit) { return unit.r != unit.g || unit.g != unit.b; }

} // namespace

double powerUnitOf(const LightSet& lights) {
    const glm::dvec3 strongest = strongestOf(lights);
    const double most = strongest[brightestBand(strongest)];
    return most > 0.0 ? std::exp2(std::floor(std::log2(most))) : 1.0;
}

glm::dvec3 colouredUnitOf(const LightSet& lights) {
    const double unit = powerUnitOf(lights);
    const glm::dvec3 strongest = strongestOf(lights);
    const double most = strongest[brightestBand(strongest)];
    return most > 0.0 && haveColour(lights, strongest) ? strongest / most * unit : glm::dvec3(unit);
}

LightSet inPowerUnits(LightSet lights, const glm::dvec3& unit) {
    const int band = brightestBand(unit);
    forEachStrength(lights, [&](glm::dvec3& strength) {
        strength = isColoured(unit) ? glm::dvec3(strength[band] / unit[band]) : strength / unit;
    });
    return lights;
}

void leavePowerUnits(BakeResult& result, const glm::dvec3& unit) {
    const glm::vec3 factor(unit);
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

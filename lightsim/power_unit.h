#pragma once
// The unit that a bake measures power in: kernels work in single precision, whatever power the lights of a scene have. In grey
// matter it can have the colour of the lights, so that one band of grey light stands for all.

#include "lightsim/bake.h"
#include "lightsim/light_set.h"

namespace eikonal::bake {

/// Calls visit(strength) with the power or irradiance of every light, which it may change.
template <class Visit>
void forEachStrength(LightSet& lights, const Visit& visit) {
    for (Light& light : lights.lights) {
        std::visit([&](auto& one) {
            if constexpr (requires { one.irradiance; }) {
                visit(one.irradiance);
            } else {
                visit(one.power);
            }
        }, light);
    }
    for (DirectionalLight& beam : lights.environment) {
        visit(beam.irradiance);
    }
}

/// The power of two just below the strongest power or irradiance of a light, so that dividing by it changes no bit of a result;
/// 1 without light.
double powerUnitOf(const LightSet& lights);

/// The same by band: where all lights have one colour, what makes them grey, and in the brightest band as before.
glm::dvec3 colouredUnitOf(const LightSet& lights);

/// The lights with powers and irradiances in such units.
LightSet inPowerUnits(LightSet lights, const glm::dvec3& unit);

/// A bake that was made in such units, in the scene's own.
void leavePowerUnits(BakeResult& result, const glm::dvec3& unit);

/// The ledger of so many times the light, by band (lightsim/statistics.cpp).
EnergyLedger operator*(EnergyLedger ledger, const glm::dvec3& factor);

} // namespace eikonal::bake

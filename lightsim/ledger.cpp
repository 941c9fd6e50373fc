#include "lightsim/ledger.h"

#include "lightsim/light_sums.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal {

glm::dvec3 EnergyLedger::balance() const {
    const glm::dvec3 accounted = absorbed + scattered + exited + reflected + culled;
    glm::dvec3 rest(0.0);
    for (int band = 0; band < 3; ++band) {
        rest[band] = entered[band] > 0.0 ? 1.0 - accounted[band] / entered[band] : 0.0;
    }
    return rest;
}

EnergyLedger& EnergyLedger::operator+=(const EnergyLedger& other) {
    for (const auto row : {&EnergyLedger::emitted, &EnergyLedger::entered, &EnergyLedger::absorbed,
                           &EnergyLedger::absorbedOpaque, &EnergyLedger::scattered, &EnergyLedger::exited,
                           &EnergyLedger::reflected, &EnergyLedger::culled, &EnergyLedger::depositedAbsorbed,
                           &EnergyLedger::depositedScattered}) {
        this->*row += other.*row;
    }
    return *this;
}

namespace bake {

void readLedger(const gpu::Buffer& rows, double unit, EnergyLedger& ledger) {
    const auto words = rows.download<std::uint32_t>(LEDGER_ROWS * 3 * 2);
    const auto row = [&](std::size_t i) {
        glm::dvec3 power;
        for (std::size_t band = 0; band < 3; ++band) {
            const std::size_t word = 2 * (3 * i + band);
            power[int(band)] = fixedPointValue(words[word], words[word + 1]) * unit;
        }
        return power;
    };
    ledger.entered = row(LEDGER_ENTERED);
    ledger.absorbedOpaque = row(LEDGER_OPAQUE);
    ledger.absorbed = row(LEDGER_ABSORBED) + ledger.absorbedOpaque;
    ledger.scattered = row(LEDGER_SCATTERED);
    ledger.exited = row(LEDGER_EXITED);
    ledger.reflected = row(LEDGER_REFLECTED);
    ledger.culled = row(LEDGER_CULLED);
}

void integrateDeposits(const Fields& fields, const BakedLight& light, EnergyLedger& ledger) {
    const double volume = light.lattice.voxel * light.lattice.voxel * light.lattice.voxel;
    for (std::size_t i = 0; i < light.irradiance.values.size(); ++i) {
        const double freeShare = fields.opaque.empty() ? 1.0 : 1.0 - fields.opaque.values[i];
        const glm::dvec3 energy = glm::dvec3(light.irradiance.values[i]) * (volume * freeShare);
        if (!fields.sigmaA.empty()) {
            ledger.depositedAbsorbed += glm::dvec3(fields.sigmaA.values[i]) * energy;
        }
        if (!fields.sigmaS.empty()) {
            ledger.depositedScattered += glm::dvec3(fields.sigmaS.values[i]) * energy;
        }
    }
}

} // namespace bake
} // namespace eikonal

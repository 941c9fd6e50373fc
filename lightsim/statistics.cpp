// Statistics of several runs as those of one.

#include <algorithm>
#include <array>

#include "lightsim/bake.h"
#include "lightsim/power_unit.h"

namespace eikonal {

namespace {

constexpr std::array kLedgerRows{
    &EnergyLedger::emitted,        &EnergyLedger::entered,   &EnergyLedger::absorbed,  &EnergyLedger::absorbedOpaque,
    &EnergyLedger::absorbedByTint, &EnergyLedger::scattered, &EnergyLedger::exited,    &EnergyLedger::reflected,
    &EnergyLedger::followed,       &EnergyLedger::culled,    &EnergyLedger::depositedAbsorbed,
    &EnergyLedger::depositedScattered};

} // namespace

EnergyLedger& EnergyLedger::operator+=(const EnergyLedger& other) {
    for (const auto row : kLedgerRows) {
        this->*row += other.*row;
    }
    return *this;
}

EnergyLedger EnergyLedger::ofBand(const glm::dvec3& toRgb) const {
    EnergyLedger result;
    for (const auto row : kLedgerRows) {
        result.*row = toRgb * (this->*row).x;
    }
    return result;
}

void BakeStatistics::addRun(const BakeStatistics& run) {
    seconds.upload += run.seconds.upload;
    seconds.propagate += run.seconds.propagate;
    seconds.lobes += run.seconds.lobes;
    seconds.read += run.seconds.read;
    seconds.total += run.seconds.total;
    patches.peak = std::max(patches.peak, run.patches.peak);
    patches.steps += run.patches.steps;
    patches.fieldEvaluations += run.patches.fieldEvaluations;
    patches.splits += run.patches.splits;
    patches.folds += run.patches.folds;
    patches.refusedSplits += run.patches.refusedSplits;
    energy += run.energy;
    for (const BandLedger& band : run.bands) {
        const auto same = std::find_if(bands.begin(), bands.end(), [&](const BandLedger& known) {
            return known.wavelengthNm == band.wavelengthNm;
        });
        if (same == bands.end()) {
            bands.push_back(band);
        } else {
            same->energy += band.energy;
        }
    }
    device = run.device;
    interpolation = run.interpolation;
    memoryBytes = std::max(memoryBytes, run.memoryBytes);
}

namespace bake {

EnergyLedger operator*(EnergyLedger ledger, const glm::dvec3& factor) {
    for (const auto row : kLedgerRows) {
        ledger.*row *= factor;
    }
    return ledger;
}

} // namespace bake

} // namespace eikonal

#include "tools/statistics_json.h"

#include <array>

#include <nlohmann/json.hpp>

#include "common/accuracy.h"

namespace eikonal {

namespace {

using LedgerRow = glm::dvec3 EnergyLedger::*;

struct NamedRow {
    const char* name;
    LedgerRow row;
};

constexpr std::array kRows{NamedRow{"emitted", &EnergyLedger::emitted},
                           NamedRow{"entered", &EnergyLedger::entered},
                           NamedRow{"absorbed", &EnergyLedger::absorbed},
                           NamedRow{"absorbed_opaque", &EnergyLedger::absorbedOpaque},
                           NamedRow{"absorbed_by_tint", &EnergyLedger::absorbedByTint},
                           NamedRow{"scattered", &EnergyLedger::scattered},
                           NamedRow{"exited", &EnergyLedger::exited},
                           NamedRow{"reflected", &EnergyLedger::reflected},
                           NamedRow{"followed", &EnergyLedger::followed},
                           NamedRow{"culled", &EnergyLedger::culled},
                           NamedRow{"deposited_absorbed", &EnergyLedger::depositedAbsorbed},
                           NamedRow{"deposited_scattered", &EnergyLedger::depositedScattered}};

nlohmann::json ofChannels(const glm::dvec3& value) { return {value.r, value.g, value.b}; }

nlohmann::json channelsJson(const EnergyLedger& energy) {
    nlohmann::json rows{{"balance", ofChannels(energy.balance())}};
    for (const NamedRow& row : kRows) {
        rows[row.name] = ofChannels(energy.*row.row);
    }
    return rows;
}

nlohmann::json bandsJson(const std::vector<BandLedger>& bands) {
    nlohmann::json rows;
    for (const BandLedger& band : bands) {
        rows["wavelengths_nm"].push_back(band.wavelengthNm);
        rows["balance"].push_back(band.energy.balance().x);
        for (const NamedRow& row : kRows) {
            rows[row.name].push_back((band.energy.*row.row).x);
        }
    }
    return rows;
}

/// By stage, `other` what is none of them; their sum is `total`.
nlohmann::json secondsJson(const BakeSeconds& seconds) {
    nlohmann::json json{{"total", seconds.total}};
    double other = seconds.total;
    for (const auto& [stage, value] : stagesOf(seconds)) {
        json[stage] = value;
        other -= value;
    }
    json["other"] = other;
    return json;
}

} // namespace

nlohmann::json energyJson(const BakeStatistics& statistics) {
    return statistics.bands.empty() ? channelsJson(statistics.energy) : bandsJson(statistics.bands);
}

nlohmann::json effectsJson(const EffectSet& effects) {
    nlohmann::json rows = nlohmann::json::array();
    for (const EffectDecision& decision : effects.decisions) {
        rows.push_back({{"name", effectName(decision.effect)}, {"on", decision.on}, {"why", decision.why}});
    }
    return rows;
}

std::vector<std::pair<std::string, double>> stagesOf(const BakeSeconds& seconds) {
    return {{"upload", seconds.upload}, {"propagate", seconds.propagate}, {"lobes", seconds.lobes}, {"read", seconds.read}};
}

nlohmann::json bakeJson(const BakeStatistics& statistics, const EffectSet& effects) {
    const PatchCounts& patches = statistics.patches;
    return {
        {"seconds", secondsJson(statistics.seconds)},
        {"patches",
         {{"peak", patches.peak},
          {"steps", patches.steps},
          {"field_evaluations", patches.fieldEvaluations},
          {"splits", patches.splits},
          {"folds", patches.folds},
          {"refused_splits", patches.refusedSplits}}},
        {"lobe_voxels", statistics.lobeVoxels},
        {"energy", energyJson(statistics)},
        {"integrator", "leapfrog"},
        {"interpolation", interpolationName(statistics.interpolation)},
        {"effects", effectsJson(effects)},
        {"device", statistics.device},
        {"memory_bytes", statistics.memoryBytes},
    };
}

nlohmann::json errorJson(const ErrorEstimate& estimate) {
    return {{"total", estimate.total},       {"step", estimate.step},     {"interpolation", estimate.interpolation},
            {"sampling", estimate.sampling}, {"pixels", estimate.pixels}, {"seconds", estimate.seconds}};
}

nlohmann::json errorJson(const BakeErrorEstimate& estimate) {
    return {{"total", estimate.total},
            {"propagation", estimate.propagation},
            {"averaging", estimate.averaging},
            {"field_evaluations", estimate.fieldEvaluations},
            {"seconds", estimate.seconds}};
}

nlohmann::json renderJson(const RenderStatistics& statistics, const EffectSet& effects) {
    nlohmann::json textures = nlohmann::json::array();
    for (const auto& [name, bytes] : statistics.textures) {
        textures.push_back({{"name", name}, {"bytes", bytes}});
    }
    return {
        {"rays", statistics.rays},
        {"reflected_rays", statistics.reflectedRays},
        {"samples", statistics.samples},
        {"noise", statistics.samples >= 2.0 ? nlohmann::json(statistics.noise) : nlohmann::json()},
        {"steps", statistics.steps},
        {"field_evaluations", statistics.fieldEvaluations},
        {"clearance_look_ups", statistics.clearanceLookUps},
        {"matter_samples", statistics.matterSamples},
        {"effects", effectsJson(effects)},
        {"device", statistics.device},
        {"memory_bytes", statistics.memoryBytes},
        {"textures", textures},
    };
}

} // namespace eikonal

#include "tools/statistics_json.h"

#include <nlohmann/json.hpp>

namespace eikonal {

namespace {

nlohmann::json byBand(const glm::dvec3& value) { return {value.r, value.g, value.b}; }

} // namespace

nlohmann::json energyJson(const EnergyLedger& energy) {
    return {
        {"emitted", byBand(energy.emitted)},
        {"entered", byBand(energy.entered)},
        {"absorbed", byBand(energy.absorbed)},
        {"absorbed_opaque", byBand(energy.absorbedOpaque)},
        {"scattered", byBand(energy.scattered)},
        {"exited", byBand(energy.exited)},
        {"reflected", byBand(energy.reflected)},
        {"followed", byBand(energy.followed)},
        {"culled", byBand(energy.culled)},
        {"balance", byBand(energy.balance())},
        {"deposited_absorbed", byBand(energy.depositedAbsorbed)},
        {"deposited_scattered", byBand(energy.depositedScattered)},
    };
}

nlohmann::json effectsJson(const EffectSet& effects) {
    nlohmann::json rows = nlohmann::json::array();
    for (const EffectDecision& decision : effects.decisions) {
        rows.push_back({{"name", effectName(decision.effect)}, {"on", decision.on}, {"why", decision.why}});
    }
    return rows;
}

nlohmann::json bakeJson(const BakeStatistics& statistics, const EffectSet& effects) {
    const BakeSeconds& seconds = statistics.seconds;
    const PatchCounts& patches = statistics.patches;
    return {
        {"seconds",
         {{"upload", seconds.upload},
          {"propagate", seconds.propagate},
          {"lobes", seconds.lobes},
          {"read", seconds.read},
          {"total", seconds.total}}},
        {"patches",
         {{"peak", patches.peak},
          {"steps", patches.steps},
          {"field_evaluations", patches.fieldEvaluations},
          {"splits", patches.splits},
          {"folds", patches.folds},
          {"refused_splits", patches.refusedSplits}}},
        {"lobe_voxels", statistics.lobeVoxels},
        {"energy", energyJson(statistics.energy)},
        {"effects", effectsJson(effects)},
        {"device", statistics.device},
        {"memory_bytes", statistics.memoryBytes},
    };
}

nlohmann::json renderJson(const RenderStatistics& statistics, const EffectSet& effects) {
    nlohmann::json seconds = nlohmann::json::object();
    for (const auto& [stage, value] : statistics.seconds) {
        seconds[stage] = value;
    }
    nlohmann::json textures = nlohmann::json::array();
    for (const auto& [name, bytes] : statistics.textures) {
        textures.push_back({{"name", name}, {"bytes", bytes}});
    }
    return {
        {"seconds", seconds},
        {"rays", statistics.rays},
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

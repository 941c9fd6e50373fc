#pragma once
// What `--stats` writes: statistics of a bake and of an image as JSON (README, docs/performance.md).

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "common/effects.h"
#include "lightsim/bake.h"
#include "lightsim/error_estimate.h"
#include "viewer/error_estimate.h"
#include "viewer/render.h"

namespace eikonal {

/// A list by band in every row: red, green, blue, or the spectral bands with their wavelengths, long ones first.
nlohmann::json energyJson(const BakeStatistics& statistics);
nlohmann::json effectsJson(const EffectSet& effects);
/// All but `total` and what is left of it.
std::vector<std::pair<std::string, double>> stagesOf(const BakeSeconds& seconds);
/// `seconds` are those of the light alone.
nlohmann::json bakeJson(const BakeStatistics& statistics, const EffectSet& effects);
nlohmann::json errorJson(const ErrorEstimate& estimate);
nlohmann::json errorJson(const BakeErrorEstimate& estimate);
/// Without `seconds`.
nlohmann::json renderJson(const RenderStatistics& statistics, const EffectSet& effects);

} // namespace eikonal

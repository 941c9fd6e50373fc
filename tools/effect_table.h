#pragma once
// Effects as people read them: on or off, with how much memory, which grids, and why.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "common/effects.h"
#include "tools/scene_arguments.h"
#include "tools/terminal.h"

namespace eikonal {

/// Lines of a table, of the rows of effectRows (common/scene_summary.h).
std::string effectTable(const nlohmann::json& rows);

/// Prints the table if the arguments ask for it.
void explainEffects(const SceneArguments& arguments, const EffectSet& effects, const Fields& fields, Progress& progress);

} // namespace eikonal

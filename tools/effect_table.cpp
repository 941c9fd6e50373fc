#include "tools/effect_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/scene_summary.h"

namespace eikonal {

namespace {

std::string megabytes(const nlohmann::json& row) {
    return !row["on"].get<bool>() || row["grids"].empty() ? "" : fmt::format("{:.2f} MiB", row["bytes"].get<double>() / (1024.0 * 1024.0));
}

std::string namesOf(const nlohmann::json& grids) {
    std::string names;
    for (const auto& grid : grids) {
        names += (names.empty() ? "" : ", ") + grid.get<std::string>();
    }
    return names;
}

} // namespace

std::string effectTable(const nlohmann::json& rows) {
    std::string table;
    for (const nlohmann::json& row : rows) {
        table += fmt::format("  {:<12} {:<4} {:>10}  {:<23} {}\n", row["name"].get<std::string>(), row["on"].get<bool>() ? "on" : "off",
                             megabytes(row), namesOf(row["grids"]), row["why"].get<std::string>());
    }
    return table;
}

void explainEffects(const SceneArguments& arguments, const EffectSet& effects, const Fields& fields, Progress& progress) {
    if (arguments.explain) {
        progress.finish();
        fmt::print("{}", effectTable(effectRows(effects, fields)));
    }
}

} // namespace eikonal

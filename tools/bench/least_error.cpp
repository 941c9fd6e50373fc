#include "tools/bench/least_error.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/core.h>

namespace eikonal::bench {

namespace {

constexpr double kSameError = 1.01;  // settings whose errors differ by less are as good as each other

using Rows = std::vector<const Measurement*>;

double leastErrorOf(const Rows& rows) {
    double least = std::numeric_limits<double>::infinity();
    for (const Measurement* row : rows) {
        least = std::min(least, row->errors.front());
    }
    return least;
}

/// nullptr: none reaches it.
const Measurement* cheapestFor(const Rows& rows, double error) {
    const Measurement* best = nullptr;
    for (const Measurement* row : rows) {
        if (row->errors.front() <= error && (!best || row->evaluations < best->evaluations)) {
            best = row;
        }
    }
    return best;
}

std::string describe(const std::string& scene, int resolution, const Rows& peaks, const Rows& tubes) {
    const double least = leastErrorOf(peaks);
    const Measurement* peak = cheapestFor(peaks, kSameError * least);
    const Measurement* tube = cheapestFor(tubes, least);
    std::string text = fmt::format("| {}, {}³ | {:.2g} % | {:.3g} |", scene, resolution, 100.0 * least, peak->evaluations);
    return tube ? text + fmt::format(" {}: {:.3g} | {:.1f} |\n", tube->setting, tube->evaluations,
                                     peak->evaluations / tube->evaluations)
                : text + " – | – |\n";
}

} // namespace

std::string comparedWithPeak(const Family& irradiance) {
    std::vector<std::pair<std::string, int>> cases;
    std::map<std::pair<std::string, int>, std::pair<Rows, Rows>> rows;
    for (const Measurement& row : irradiance.rows) {
        const std::pair key{row.scene, row.resolution};
        if (rows.find(key) == rows.end()) cases.push_back(key);
        auto& [peaks, tubes] = rows[key];
        if (row.method == kPeakName) peaks.push_back(&row);
        if (row.method == kAutoName) tubes.push_back(&row);
    }
    std::string text = "At the least error that the method of 2007 reaches:\n\n| case | error | field evaluations of peak | of auto "
                       "| ratio |\n|---|---|---|---|---|\n";
    for (const auto& key : cases) {
        const auto& [peaks, tubes] = rows.at(key);
        text += describe(key.first, key.second, peaks, tubes);
    }
    return text + "\n";
}

} // namespace eikonal::bench

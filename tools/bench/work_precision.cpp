#include "tools/bench/work_precision.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "tools/bench/log_plot.h"

namespace eikonal::bench {

namespace {

constexpr std::array kTargets = {0.05, 0.01, 0.001};
constexpr double kRightWithin = 3.0;  // factor of the true error: what estimates are meant to keep

std::vector<std::string> scenesOf(const Family& family) {
    std::vector<std::string> scenes;
    for (const Measurement& row : family.rows) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) {
            scenes.push_back(row.scene);
        }
    }
    return scenes;
}

/// The cheapest on voxels, or nullptr.
const Measurement* cheapest(const Family& family, const std::string& scene, double target) {
    const Measurement* best = nullptr;
    for (const Measurement& row : family.rows) {
        const bool reaches = row.scene == scene && row.resolution > 0 && row.errors.front() <= target;
        if (reaches && (!best || row.evaluations < best->evaluations)) {
            best = &row;
        }
    }
    return best;
}

std::string describe(const Measurement* row) {
    if (!row) {
        return "–";
    }
    return fmt::format("{}, {}, {} {}³: {:.3g}", row->method, row->setting, row->field, row->resolution, row->evaluations);
}

std::string labelOf(const Measurement& row) {
    return row.resolution > 0 ? fmt::format("{}, {} {}³", row.method, row.field, row.resolution)
                              : fmt::format("{}, {}", row.method, row.field);
}

/// How far estimates are from errors, over all measurements that have both.
std::string describeEstimates(const Family& family) {
    std::vector<double> ratios, factors;
    for (const Measurement& row : family.rows) {
        if (row.estimate && *row.estimate > 0.0 && row.errors.front() > 0.0) {
            ratios.push_back(*row.estimate / row.errors.front());
            factors.push_back(std::exp(std::abs(std::log(ratios.back()))));
        }
    }
    if (ratios.empty()) {
        return "";
    }
    std::sort(ratios.begin(), ratios.end());
    std::sort(factors.begin(), factors.end());
    const auto within = std::upper_bound(factors.begin(), factors.end(), kRightWithin) - factors.begin();
    return fmt::format("Estimated over true error: median {:.2f}, nine in ten within a factor of {:.2g}; {} of {} pairs of case and "
                       "setting within a factor of {:g}.\n\n",
                       ratios[ratios.size() / 2], factors[(9 * factors.size() + 9) / 10 - 1], within, factors.size(),
                       kRightWithin);
}

} // namespace

double workOf(const Measurement& row, Work work) { return work == Work::kSeconds ? row.seconds : row.evaluations; }

std::string csvOf(const Family& family) {
    std::string text = "family,case,field,resolution,method,setting,evaluations,seconds";
    for (const ErrorColumn& column : family.errors) {
        text += "," + column.name;
    }
    text += ",estimate";
    for (const Measurement& row : family.rows) {
        text += fmt::format("\n{},{},{},{},{},{},{:.6g},{:.3g}", family.name, row.scene, row.field, row.resolution, row.method,
                            row.setting, row.evaluations, row.seconds);
        for (const double error : row.errors) {
            text += fmt::format(",{:.4g}", error);
        }
        text += row.estimate ? fmt::format(",{:.4g}", *row.estimate) : ",";
    }
    return text + "\n";
}

std::string summaryOf(const Family& family) {
    std::string text = fmt::format("## {}\n\nCheapest setting on voxels for an error of at most 5 %, 1 % and 0.1 % ({}), and its "
                                   "{}:\n\n| case | 5 % | 1 % | 0.1 % |\n|---|---|---|---|\n",
                                   family.title, family.errors.front().label, family.workLabel);
    for (const std::string& scene : scenesOf(family)) {
        text += fmt::format("| {} |", scene);
        for (const double target : kTargets) {
            text += fmt::format(" {} |", describe(cheapest(family, scene, target)));
        }
        text += "\n";
    }
    return text + "\n" + describeEstimates(family) + family.notes;
}

std::string diagramOf(const Family& family, Work work) {
    LogPlot plot{family.title, work == Work::kSeconds ? "seconds" : family.workLabel, family.errors.front().label, {}};
    std::map<std::string, int> colours;  // by method, the same in every panel
    for (const Measurement& row : family.rows) {
        colours.try_emplace(row.method, int(colours.size()));
    }
    for (const std::string& scene : scenesOf(family)) {
        LogPanel& panel = plot.panels.emplace_back(LogPanel{scene, {}});
        for (const Measurement& row : family.rows) {
            if (row.scene != scene || row.line == Line::kNone) {
                continue;
            }
            if (panel.curves.empty() || panel.curves.back().label != labelOf(row)) {
                panel.curves.push_back({labelOf(row), colours.at(row.method), row.line == Line::kDashed, {}});
            }
            if (row.errors.front() >= family.smallestDrawn) {
                panel.curves.back().points.push_back({workOf(row, work), row.errors.front()});
            }
        }
    }
    return svgOf(plot);
}

} // namespace eikonal::bench

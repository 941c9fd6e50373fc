#pragma once
// What accuracy costs: one measurement a setting, and a family of measurements that share their errors and a diagram.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal::bench {

enum class Line { kSolid, kDashed, kNone };  ///< how a measurement's curve is drawn, if at all

struct Measurement {
    std::string scene;   ///< the case
    std::string field;   ///< what interpolates it: "closed form", "linear", "cubic"
    int resolution = 0;  ///< voxels along the longest side
    std::string method;
    std::string setting; ///< "step 0.5 voxels", "tolerance 0.02"
    double evaluations = 0.0;  ///< of the index field, per ray or in all
    double seconds = 0.0;
    std::vector<double> errors; ///< as many as the family names
    Line line = Line::kNone;
    std::optional<double> estimate;  ///< of the first error, without the truth
};

struct ErrorColumn {
    std::string name;   ///< in the CSV
    std::string label;  ///< beside the diagram, with unit
};

struct Family {
    std::string name;   ///< "rays": of its files
    std::string title;
    std::string workLabel;             ///< of evaluations
    std::vector<ErrorColumn> errors;   ///< the first one is drawn and judged
    double smallestDrawn;              ///< errors below it are left out of the diagram
    std::vector<Measurement> rows;     ///< curve after curve, each from coarse to fine
    std::string notes;                 ///< Markdown, below the summary
};

enum class Work { kEvaluations, kSeconds };

double workOf(const Measurement& row, Work work);

/// Header and a row for each measurement, in order. The last column is the estimate of the first error, if there is any.
std::string csvOf(const Family& family);

/// Markdown: for each case the cheapest setting, by field evaluations, whose first error is at most 5 %, 1 % and 0.1 %, among
/// those on voxels; how good the estimates are; the notes.
std::string summaryOf(const Family& family);

/// SVG: the first error over the work, both logarithmic; a panel for each case.
std::string diagramOf(const Family& family, Work work);

} // namespace eikonal::bench

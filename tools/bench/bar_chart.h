#pragma once
// Horizontal bars as SVG.

#include <string>
#include <vector>

namespace eikonal::bench {

struct Bar {
    std::string label;
    double value = 0.0;
    std::string note;  ///< stands at the bar's end
};

/// A picture of the bars, longest to the right edge, on white. Labels may hold any text.
std::string barChartSvg(const std::string& title, const std::vector<Bar>& bars);

} // namespace eikonal::bench

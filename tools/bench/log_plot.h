#pragma once
// Diagrams with two logarithmic axes as SVG: small panels that share their scales, one legend.

#include <string>
#include <vector>

namespace eikonal::bench {

struct LogPoint {
    double x, y;  ///< above 0; others are left out
};

struct LogCurve {
    std::string label;  ///< equal ones of different panels share an entry of the legend
    int colour = 0;     ///< index into a palette that colour-blind readers can tell apart
    bool dashed = false;
    std::vector<LogPoint> points;
};

struct LogPanel {
    std::string title;
    std::vector<LogCurve> curves;
};

struct LogPlot {
    std::string title, xLabel, yLabel;
    std::vector<LogPanel> panels;
};

std::string svgOf(const LogPlot& plot);

} // namespace eikonal::bench

#include "tools/bench/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

namespace eikonal::bench {

namespace {

// M. Okabe, K. Ito, Color Universal Design (2008), without the yellow that fades on white.
constexpr std::array kPalette = {"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};
constexpr double kPanelWidth = 230.0, kPanelHeight = 190.0, kGapX = 62.0, kGapY = 66.0, kTop = 62.0;
constexpr double kLegendRow = 18.0, kLegendColumn = 215.0;
constexpr int kColumns = 3, kLegendColumns = 4;

/// Whole decades that hold every value.
struct Decades {
    int low = 0, high = 1;

    double place(double value) const { return (std::log10(value) - low) / (high - low); }
    /// Powers of ten with a number: at most seven.
    int labelStep() const { return (high - low + 6) / 7; }
};

bool isDrawn(const LogPoint& point) { return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x * point.y); }

Decades decadesOf(const LogPlot& plot, double LogPoint::*axis) {
    double low = 1e300, high = 1e-300;
    for (const LogPanel& panel : plot.panels) {
        for (const LogCurve& curve : panel.curves) {
            for (const LogPoint& point : curve.points) {
                if (isDrawn(point)) {
                    low = std::min(low, point.*axis);
                    high = std::max(high, point.*axis);
                }
            }
        }
    }
    if (low > high) {
        return {};
    }
    const int first = int(std::floor(std::log10(low)));
    return {first, std::max(first + 1, int(std::ceil(std::log10(high))))};
}

std::string textAt(double x, double y, const char* attributes, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, text);
}

std::string lineFrom(double x0, double y0, double x1, double y1, const std::string& attributes) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x0, y0, x1, y1, attributes);
}

const char* colourOf(const LogCurve& curve) { return kPalette[std::size_t(curve.colour) % kPalette.size()]; }

std::string strokeOf(const LogCurve& curve) {
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}", colourOf(curve),
                       curve.dashed ? " stroke-dasharray=\"4 3\"" : "");
}

std::string powerOfTen(int exponent) {
    return fmt::format("10<tspan dy=\"-4\" font-size=\"8\">{}{}</tspan>", exponent < 0 ? "−" : "", std::abs(exponent));
}

/// A panel's frame, with a grid line and a tick at each decade.
std::string axesOf(const Decades& across, const Decades& up) {
    std::string svg;
    for (int decade = across.low; decade <= across.high; ++decade) {
        const double x = kPanelWidth * (decade - across.low) / (across.high - across.low);
        svg += lineFrom(x, 0.0, x, kPanelHeight + 4.0, "stroke=\"#ddd\"");
        if ((decade - across.low) % across.labelStep() == 0) {
            svg += textAt(x, kPanelHeight + 17.0, "text-anchor=\"middle\" font-size=\"10\"", powerOfTen(decade));
        }
    }
    for (int decade = up.low; decade <= up.high; ++decade) {
        const double y = kPanelHeight * (1.0 - double(decade - up.low) / (up.high - up.low));
        svg += lineFrom(-4.0, y, kPanelWidth, y, "stroke=\"#ddd\"");
        if ((decade - up.low) % up.labelStep() == 0) {
            svg += textAt(-7.0, y + 3.5, "text-anchor=\"end\" font-size=\"10\"", powerOfTen(decade));
        }
    }
    return svg + fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666\"/>\n", kPanelWidth, kPanelHeight);
}

std::string curveOf(const LogCurve& curve, const Decades& across, const Decades& up) {
    std::string points, marks;
    for (const LogPoint& point : curve.points) {
        if (isDrawn(point)) {
            const double x = kPanelWidth * across.place(point.x), y = kPanelHeight * (1.0 - up.place(point.y));
            points += fmt::format("{:.1f},{:.1f} ", x, y);
            marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"{}\"/>\n", x, y,
                                 colourOf(curve));
        }
    }
    return fmt::format("<polyline points=\"{}\" {}/>\n", points, strokeOf(curve)) + marks;
}

std::string panelAt(const LogPlot& plot, std::size_t index, const Decades& across, const Decades& up) {
    const LogPanel& panel = plot.panels[index];
    const double x = kGapX + double(index % kColumns) * (kPanelWidth + kGapX);
    const double y = kTop + double(index / kColumns) * (kPanelHeight + kGapY);
    std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", x, y) + axesOf(across, up);
    svg += textAt(0.0, -8.0, "font-size=\"13\" font-weight=\"bold\"", panel.title);
    svg += textAt(0.5 * kPanelWidth, kPanelHeight + 33.0, "text-anchor=\"middle\" font-size=\"11\"", plot.xLabel);
    if (index % kColumns == 0) {
        svg += textAt(0.0, 0.0,
                      fmt::format("transform=\"translate(-42 {}) rotate(-90)\" text-anchor=\"middle\" font-size=\"11\"",
                                  0.5 * kPanelHeight).c_str(),
                      plot.yLabel);
    }
    for (const LogCurve& curve : panel.curves) {
        svg += curveOf(curve, across, up);
    }
    return svg + "</g>\n";
}

/// One curve of every label, in order of appearance.
std::vector<LogCurve> legendOf(const LogPlot& plot) {
    std::vector<LogCurve> entries;
    for (const LogPanel& panel : plot.panels) {
        for (const LogCurve& curve : panel.curves) {
            const auto same = [&](const LogCurve& entry) { return entry.label == curve.label; };
            if (std::none_of(entries.begin(), entries.end(), same)) {
                entries.push_back(curve);
            }
        }
    }
    return entries;
}

std::string legendAt(double top, const std::vector<LogCurve>& entries) {
    std::string svg;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const double x = kGapX + double(i % kLegendColumns) * kLegendColumn, y = top + double(i / kLegendColumns) * kLegendRow;
        svg += lineFrom(x, y - 4.0, x + 26.0, y - 4.0, strokeOf(entries[i]));
        svg += textAt(x + 33.0, y, "font-size=\"11\"", entries[i].label);
    }
    return svg;
}

} // namespace

std::string svgOf(const LogPlot& plot) {
    const Decades across = decadesOf(plot, &LogPoint::x), up = decadesOf(plot, &LogPoint::y);
    const std::vector<LogCurve> legend = legendOf(plot);
    const auto rowsOf = [](std::size_t count, std::size_t columns) { return double((count + columns - 1) / columns); };
    const double width = kGapX + kColumns * (kPanelWidth + kGapX);
    const double legendTop = kTop + rowsOf(plot.panels.size(), kColumns) * (kPanelHeight + kGapY);
    const double height = legendTop + rowsOf(legend.size(), kLegendColumns) * kLegendRow + 4.0;
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                                  "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" fill=\"#222\">\n"
                                  "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
                                  width, height);
    svg += textAt(kGapX, 26.0, "font-size=\"15\" font-weight=\"bold\"", plot.title);
    for (std::size_t i = 0; i < plot.panels.size(); ++i) {
        svg += panelAt(plot, i, across, up);
    }
    return svg + legendAt(legendTop, legend) + "</svg>\n";
}

} // namespace eikonal::bench

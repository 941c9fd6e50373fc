#include "tools/bench/bar_chart.h"

#include <algorithm>

#include <fmt/format.h>

namespace eikonal::bench {

namespace {

constexpr double kLabelWidth = 140.0, kBarWidth = 420.0, kNoteWidth = 240.0, kRow = 30.0, kTop = 52.0;  // pixels

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else safe += c;
    }
    return safe;
}

std::string row(const Bar& bar, double longest, double y) {
    const double length = longest > 0.0 ? kBarWidth * bar.value / longest : 0.0;
    return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>\n"
                       "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"#3b6ea5\"/>\n"
                       "<text x=\"{:.1f}\" y=\"{:.0f}\" fill=\"#555\">{}</text>\n",
                       kLabelWidth - 8.0, y + 0.62 * kRow, escaped(bar.label), kLabelWidth, y + 0.15 * kRow, length,
                       0.7 * kRow, kLabelWidth + length + 8.0, y + 0.62 * kRow, escaped(bar.note));
}

} // namespace

std::string barChartSvg(const std::string& title, const std::vector<Bar>& bars) {
    double longest = 0.0;
    for (const Bar& bar : bars) longest = std::max(longest, bar.value);
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
                                  "font-family=\"sans-serif\" font-size=\"14\">\n"
                                  "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                                  "<text x=\"16\" y=\"28\" font-size=\"17\">{}</text>\n",
                                  kLabelWidth + kBarWidth + kNoteWidth, kTop + kRow * double(bars.size()) + 16.0,
                                  escaped(title));
    double y = kTop;
    for (const Bar& bar : bars) {
        svg += row(bar, longest, y);
        y += kRow;
    }
    return svg + "</svg>\n";
}

} // namespace eikonal::bench

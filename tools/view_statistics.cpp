#include "tools/view_statistics.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace eikonal {

namespace {

using window::Instant;
using window::LightAnswer;
using window::MovingFrame;

constexpr double kMilliseconds = 1e3;

/// `of` of every row, ascending.
template <class Row, class Of>
auto sorted(const std::vector<Row>& rows, Of of) {
    std::vector<decltype(of(rows.front()))> values;
    for (const Row& row : rows) values.push_back(of(row));
    std::sort(values.begin(), values.end());
    return values;
}

template <class Row, class Of>
nlohmann::json spread(const std::vector<Row>& rows, Of of) {
    if (rows.empty()) return nullptr;
    const auto values = sorted(rows, of);
    return {{"median", values[values.size() / 2]}, {"longest", values.back()}};
}

template <class Row, class Of>
nlohmann::json each(const std::vector<Row>& rows, Of of) {
    nlohmann::json values = nlohmann::json::array();
    for (const Row& row : rows) values.push_back(of(row));
    return values;
}

nlohmann::json sizesJson(const std::vector<MovingFrame>& frames) {
    if (frames.empty()) return nullptr;
    const auto widths = sorted(frames, [](const MovingFrame& frame) { return frame.size.x; });
    const auto heights = sorted(frames, [](const MovingFrame& frame) { return frame.size.y; });
    const std::size_t middle = frames.size() / 2;
    return {{"smallest", {widths.front(), heights.front()}}, {"median", {widths[middle], heights[middle]}}};
}

} // namespace

nlohmann::json viewJson(const window::ResponseRecord& record) {
    const auto& [moving, lights, refinements] = record;
    return {
        {"moving",
         {{"frames", moving.size()},
          {"milliseconds", spread(moving, [](const MovingFrame& f) { return kMilliseconds * f.took.clock; })},
          {"processor_milliseconds", spread(moving, [](const MovingFrame& f) { return kMilliseconds * f.took.processor; })},
          {"picture", sizesJson(moving)}}},
        {"light",
         {{"drags", lights.size()},
          {"milliseconds", spread(lights, [](const LightAnswer& l) { return kMilliseconds * l.took.clock; })},
          {"processor_milliseconds", spread(lights, [](const LightAnswer& l) { return kMilliseconds * l.took.processor; })},
          {"frames", spread(lights, [](const LightAnswer& l) { return l.frames; })}}},
        {"refinement",
         {{"seconds", each(refinements, [](const Instant& took) { return took.clock; })},
          {"processor_seconds", each(refinements, [](const Instant& took) { return took.processor; })}}},
    };
}

} // namespace eikonal

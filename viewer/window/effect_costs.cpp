#include "viewer/window/effect_costs.h"

namespace eikonal::window {

namespace {

std::vector<bool> switchesOf(const EffectSet& effects) {
    std::vector<bool> switches;
    for (const EffectDecision& decision : effects.decisions) switches.push_back(decision.on);
    return switches;
}

} // namespace

void EffectCosts::measured(const EffectSet& effects, double secondsPerRay) { seconds_[switchesOf(effects)] = secondsPerRay; }

std::optional<double> EffectCosts::cost(const EffectSet& effects, Effect effect) const {
    std::vector<bool> with = switchesOf(effects), without = with;
    with[std::size_t(effect)] = true;
    without[std::size_t(effect)] = false;
    const auto on = seconds_.find(with), off = seconds_.find(without);
    if (on == seconds_.end() || off == seconds_.end()) return std::nullopt;
    return on->second - off->second;
}

} // namespace eikonal::window

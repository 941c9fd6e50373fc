#include "tools/stage_clock.h"

#include <nlohmann/json.hpp>

namespace eikonal {

void StageClock::lap(const std::string& stage, const std::vector<std::pair<std::string, double>>& parts) {
    const Clock::time_point now = Clock::now();
    double rest = std::chrono::duration<double>(now - last_).count();
    for (const auto& [name, seconds] : parts) {
        seconds_[name] += seconds;
        rest -= seconds;
    }
    seconds_[stage] += rest;
    last_ = now;
}

nlohmann::json StageClock::take() {
    nlohmann::json taken = seconds_;
    double total = 0.0;
    for (const auto& [stage, seconds] : seconds_) {
        total += seconds;
    }
    taken["total"] = total;
    seconds_.clear();
    return taken;
}

} // namespace eikonal

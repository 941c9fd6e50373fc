#pragma once
// Where the time of a command goes that somebody waits for it.

#include <chrono>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace eikonal {

/// Seconds of stages: what has passed since the lap before belongs to the stage of the next.
class StageClock {
public:
    /// `parts` of that time are stages of their own; the rest of it is `stage`.
    void lap(const std::string& stage, const std::vector<std::pair<std::string, double>>& parts = {});
    /// Seconds by stage since the last time that they were taken, and `total`, their sum.
    nlohmann::json take();

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    std::map<std::string, double> seconds_;
};

} // namespace eikonal

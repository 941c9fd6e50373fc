#include "viewer/window/governor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eikonal::window {

namespace {

constexpr double kMemory = 0.7;        // weight of what was measured before: one slow frame changes little
constexpr std::size_t kFewestRays = 512;
constexpr std::array kDivisors = {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0};
constexpr double kLegibleDivisor = 3.0;
constexpr double kPatience = 3.0;  // frames that a legible picture may take instead of one: 100 ms at the default

glm::ivec2 divided(const glm::ivec2& size, double divisor) {
    return glm::max(glm::ivec2(glm::round(glm::dvec2(size) / divisor)), glm::ivec2(1));
}

double pixels(const glm::ivec2& size) { return double(size.x) * double(size.y); }

} // namespace

void Governor::measured(std::size_t rays, bool fine, double seconds) {
    if (rays == 0) return;
    const double now = seconds / double(rays) / (fine ? 1.0 : coarseCost_);
    secondsPerFineRay_ = kMemory * secondsPerFineRay_ + (1.0 - kMemory) * now;
}

Detail Governor::moving(const glm::ivec2& fullSize) const {
    if (pixels(fullSize) * secondsPerRay(true) <= frameSeconds_) return {fullSize, true};
    for (const double divisor : kDivisors) {
        const glm::ivec2 size = divided(fullSize, divisor);
        const double affordable = frameSeconds_ * (divisor < kLegibleDivisor ? 1.0 : kPatience);
        if (pixels(size) * secondsPerRay(false) <= affordable) return {size, false};
    }
    return {divided(fullSize, kDivisors.back()), false};
}

Detail Governor::refined(const Detail& shown, const glm::ivec2& fullSize) {
    const glm::ivec2 half = divided(fullSize, 2.0);
    if (shown.size.x < half.x) return {half, false};
    return {fullSize, true};
}

std::size_t Governor::raysWithin(double seconds, bool fine) const {
    return std::max(kFewestRays, std::size_t(std::max(seconds, 0.0) / secondsPerRay(fine)));
}

} // namespace eikonal::window

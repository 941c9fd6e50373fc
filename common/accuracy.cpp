#include "common/accuracy.h"

#include <algorithm>

#include <fmt/core.h>

#include "common/error.h"

namespace eikonal {

namespace {

constexpr double kCubicBelow = 0.002;

} // namespace

std::string_view interpolationName(Interpolation interpolation) {
    const auto isIt = [interpolation](const auto& named) { return named.second == interpolation; };
    return std::find_if(kInterpolations.begin(), kInterpolations.end(), isIt)->first;
}

Interpolation interpolationOfImages(const Accuracy& accuracy) {
    if (accuracy.interpolation != Interpolation::kAuto) return accuracy.interpolation;
    return accuracy.tolerance < kCubicBelow ? Interpolation::kCubic : Interpolation::kLinear;
}

Integrator integratorOf(const Accuracy& accuracy) {
    return accuracy.integrator == Integrator::kAuto ? Integrator::kLeapfrog : accuracy.integrator;
}

void requireAvailable(const Scene& scene) {
    const Accuracy& asked = scene.accuracy;
    if (asked.directional == Directional::kLobes && asked.deposit == Deposit::kPeak) {
        throw badInput(fmt::format("{}: accuracy.directional: expected 'auto' or 'mean' with the deposit 'peak', which keeps one "
                                   "direction, found 'lobes'",
                                   describe(scene.placeOf({"accuracy.directional", "accuracy.deposit"}))));
    }
    const bool usesPatches = asked.deposit == Deposit::kSplat || asked.deposit == Deposit::kPeak;
    if (usesPatches && asked.reflections > 0) {
        throw badInput(fmt::format("{}: accuracy.reflections: expected 0 with the deposits 'splat' and 'peak', found {}; "
                                   "'auto' and 'cells' follow reflections",
                                   describe(scene.placeOf({"accuracy.reflections", "accuracy.deposit"})), asked.reflections));
    }
}

std::optional<std::string> warningOfIntegrator(const Scene& scene) {
    const Integrator asked = integratorOf(scene.accuracy);
    if (asked == Integrator::kLeapfrog) return std::nullopt;
    const auto isIt = [asked](const auto& named) { return named.second == asked; };
    return fmt::format("{}: accuracy.integrator: '{}' is for viewing rays; light goes by leapfrog",
                       describe(scene.placeOf({"accuracy.integrator"})),
                       std::find_if(kIntegrators.begin(), kIntegrators.end(), isIt)->first);
}

} // namespace eikonal

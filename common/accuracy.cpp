#include "common/accuracy.h"

#include <fmt/core.h>

#include "common/error.h"

namespace eikonal {

namespace {

void require(const Scene& scene, bool available, const char* key, const char* expected) {
    if (!available) {
        throw badInput(fmt::format("{}: {}: expected {}; this version has no other yet", scene.source, key, expected));
    }
}

} // namespace

void requireAvailable(const Scene& scene) {
    const Accuracy& asked = scene.accuracy;
    require(scene, asked.integrator == Integrator::kAuto || asked.integrator == Integrator::kLeapfrog,
            "accuracy.integrator", "'auto' or 'leapfrog'");
    require(scene, asked.interpolation == Interpolation::kAuto || asked.interpolation == Interpolation::kLinear,
            "accuracy.interpolation", "'auto' or 'linear'");
    require(scene, asked.directional != Directional::kLobes || asked.deposit != Deposit::kPeak, "accuracy.directional",
            "'auto' or 'mean' with deposit 'peak', which keeps one direction");
    const bool usesPatches = asked.deposit == Deposit::kSplat || asked.deposit == Deposit::kPeak;
    if (usesPatches && asked.reflections > 0) {
        throw badInput(fmt::format("{}: accuracy.reflections: expected 0 with the deposits 'splat' and 'peak', found {}; "
                                   "'auto' and 'cells' follow reflections", scene.source, asked.reflections));
    }
}

} // namespace eikonal

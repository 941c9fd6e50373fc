// Every variant of every kernel of the bake compiles, and the validator of the shading language agrees.
#include "tests/support/kernel_variants.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

using test::KernelVariant;

std::vector<KernelVariant> variants() {
    std::vector<KernelVariant> rows = {{"lightsim/schedule.comp.glsl", {"BANDS 3"}},
                                       {"lightsim/schedule.comp.glsl", {"BANDS 3", "SCHEDULE_EMIT"}}};
    for (const auto& subset : test::tellingSubsets({"EFFECT_REFRACTION", "EFFECT_ABSORPTION", "EFFECT_SCATTERING",
                                                    "EFFECT_REFLECTION", "EFFECT_OPAQUE", "MANUAL_FILTERING"})) {
        for (const char* kernel : {"emit", "propagate", "refine", "retire", "split", "deposit", "deposit_corners", "deposit_peak"}) {
            rows.push_back(test::variant("lightsim/" + std::string(kernel) + ".comp.glsl", subset, {"BANDS 3"}));
        }
        for (const char* kernel : {"deposit", "deposit_corners", "deposit_peak"}) {  // the others know no bands
            rows.push_back(test::variant("lightsim/" + std::string(kernel) + ".comp.glsl", subset, {"BANDS 1"}));
        }
    }
    return rows;
}

TEST(BakeKernels, CompileInEveryVariant) { test::expectVariantsCompile(variants()); }

TEST(BakeKernels, SatisfyTheValidatorInEveryVariant) { test::expectValidatorAgrees(variants()); }

} // namespace
} // namespace eikonal

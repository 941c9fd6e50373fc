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
        for (const char* kernel : {"deposit", "deposit_corners"}) {
            for (const char* bands : {"BANDS 1", "BANDS 3"}) {
                rows.push_back(test::variant("lightsim/" + std::string(kernel) + ".comp.glsl", subset, {bands, "LIGHT_LOBES"}));
            }
        }
        for (const char* kernel : {"deposit", "deposit_corners", "deposit_peak"}) {  // the others know no bands
            rows.push_back(test::variant("lightsim/" + std::string(kernel) + ".comp.glsl", subset, {"BANDS 1"}));
        }
    }
    for (const auto& subset : test::tellingSubsets({"EFFECT_REFRACTION", "EFFECT_ABSORPTION", "EFFECT_SCATTERING",
                                                    "EFFECT_REFLECTION", "EFFECT_OPAQUE", "MANUAL_FILTERING"})) {
        rows.push_back(test::variant("lightsim/tubes/trace.comp.glsl", subset, {"BANDS 3"}));
    }
    for (const auto& subset : test::tellingSubsets({"EFFECT_ABSORPTION", "EFFECT_SCATTERING", "EFFECT_OPAQUE", "MANUAL_FILTERING"})) {
        rows.push_back(test::variant("lightsim/tubes/trace.comp.glsl", subset,
                                     {"BANDS 3", "EFFECT_REFRACTION", "EFFECT_REFLECTION", "FOLLOW_REFLECTIONS"}));
    }
    for (const char* kernel : {"emit", "propagate", "split", "tubes/trace"}) {
        rows.push_back({"lightsim/" + std::string(kernel) + ".comp.glsl",
                        {"BANDS 3", "EFFECT_REFRACTION", "EFFECT_REFLECTION", "EFFECT_TINT"}});
    }
    rows.push_back({"lightsim/tubes/trace.comp.glsl",
                    {"BANDS 3", "EFFECT_REFRACTION", "EFFECT_REFLECTION", "EFFECT_TINT", "FOLLOW_REFLECTIONS"}});
    for (const char* list : {"PART_LIST 0", "PART_LIST 1", "PART_LIST 2"}) {
        for (const auto& subset : test::tellingSubsets({"FOLLOW_REFLECTIONS", "EFFECT_OPAQUE"})) {
            rows.push_back(test::variant("lightsim/tubes/eikonal.comp.glsl", subset, {"BANDS 3", list}));
        }
    }
    for (const char* bands : {"BANDS 1", "BANDS 3"}) {
        for (const char* kernel : {"place", "trace", "measure_edges", "measure_nodes", "conform", "sort_cells", "smooth_cells", "sort_parts",
                                   "deposit_gather", "deposit_lines", "deposit_rays", "tally"}) {
            for (const auto& subset : test::tellingSubsets({"FOLLOW_REFLECTIONS", "EFFECT_OPAQUE"})) {
                rows.push_back(test::variant("lightsim/tubes/" + std::string(kernel) + ".comp.glsl", subset,
                                             {bands, "EFFECT_REFRACTION", "EFFECT_REFLECTION"}));
            }
        }
        for (const char* kernel : {"deposit_gather", "deposit_lines", "deposit_rays"}) {
            for (const auto& subset : test::tellingSubsets({"EFFECT_ABSORPTION", "EFFECT_OPAQUE", "LIGHT_LOBES"})) {
                rows.push_back(test::variant("lightsim/tubes/" + std::string(kernel) + ".comp.glsl", subset, {bands}));
            }
        }
    }
    for (const auto& subset : test::tellingSubsets({"EFFECT_ABSORPTION", "LIGHT_LOBES", "FOLLOW_REFLECTIONS"})) {
        rows.push_back(test::variant("lightsim/tubes/deposit_gather.comp.glsl", subset, {"BANDS 3", "EFFECT_OPAQUE", "CUT_VOXELS"}));
    }
    for (const auto& subset : test::tellingSubsets({"MANUAL_FILTERING"})) {
        rows.push_back(test::variant("lightsim/tubes/free_samples.comp.glsl", subset, {"BANDS 3", "EFFECT_OPAQUE"}));
    }
    for (const char* kernel : {"measure_edges", "measure_nodes"}) {
        rows.push_back({"lightsim/tubes/" + std::string(kernel) + ".comp.glsl", {"BANDS 3", "FIELD_DETAIL"}});
    }
    for (const char* kernel : {"sort_cells", "smooth_cells", "sort_parts", "deposit_gather"}) {
        rows.push_back({"lightsim/tubes/" + std::string(kernel) + ".comp.glsl",
                        {"BANDS 3", "EFFECT_OPAQUE", "GATHERS_PER_PART 8"}});
    }
    for (const char* kernel : {"emit", "propagate", "split", "deposit", "tubes/trace"}) {
        rows.push_back({"lightsim/" + std::string(kernel) + ".comp.glsl",
                        {"BANDS 3", "EFFECT_REFRACTION", "EFFECT_REFLECTION", "CUBIC_INTERPOLATION"}});
    }
    return rows;
}

TEST(BakeKernels, CompileInEveryVariant) { test::expectVariantsCompile(variants()); }

TEST(BakeKernels, SatisfyTheValidatorInEveryVariant) { test::expectValidatorAgrees(variants()); }

} // namespace
} // namespace eikonal

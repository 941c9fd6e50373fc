// Every variant of every kernel of the viewer compiles, and the validator of the shading language agrees.
#include "common/error.h"
#include "common/gpu/objects.h"
#include "common/gpu/shader_source.h"
#include "common/gpu_fields.h"
#include "tests/support/kernel_variants.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal {
namespace {

using test::KernelVariant;

std::vector<KernelVariant> variants() {
    const std::vector<std::string> switches = {
        "EFFECT_REFRACTION", "EFFECT_ABSORPTION",  "EFFECT_SCATTERING", "EFFECT_EMISSION", "EFFECT_REFLECTION",
        "EFFECT_OPAQUE",     "EFFECT_ENVIRONMENT", "ENVIRONMENT_IMAGE", "BAKED_LIGHT",     "STRAIGHT_FLIGHTS",
        "LIGHT_LOBES",       "MANUAL_FILTERING",   "FOLLOW_REFLECTIONS", "EFFECT_TINT",       "EFFECT_ROUGHNESS",
        "INSETS"};
    std::vector<KernelVariant> rows = {{"viewer/accumulate.comp.glsl", {}},
                                       {"viewer/tone_map.comp.glsl", {}},
                                       {"viewer/tone_map.comp.glsl", {"TONE_AGX"}},
                                       {"viewer/tone_map.comp.glsl", {"TONE_REINHARD"}},
                                       {"gpu/linear_filtering.comp.glsl", {}}};
    rows.push_back({"bench/dependent_fetch.comp.glsl", {"EFFECT_REFRACTION"}});
    rows.push_back({"bench/dependent_fetch.comp.glsl", {"EFFECT_REFRACTION", "MANUAL_FILTERING"}});
    auto subsets = test::tellingSubsets(switches);
    auto all = switches;
    all.push_back("EFFECT_DISPERSION");
    subsets.push_back(all);
    const std::vector<std::string> reflecting = {"EFFECT_REFRACTION", "EFFECT_REFLECTION", "FOLLOW_REFLECTIONS"};
    for (const std::vector<std::string>& surface : {std::vector<std::string>{}, {"EFFECT_TINT"}, {"EFFECT_ROUGHNESS"}}) {
        subsets.push_back(test::variant("", reflecting, surface).defines);
    }
    subsets.push_back({"EFFECT_REFRACTION", "EFFECT_DISPERSION"});  // never without refraction
    subsets.push_back({"EFFECT_REFRACTION", "EFFECT_DISPERSION", "DISPERSION_BY_REFRACTIVITY"});
    subsets.push_back({"EFFECT_REFRACTION", "EFFECT_DISPERSION", "INSETS"});
    subsets.push_back({"EFFECT_REFRACTION", "CUBIC_INTERPOLATION", "INSETS"});
    subsets.push_back({"EFFECT_REFRACTION", "CUBIC_INTERPOLATION"});
    subsets.push_back({"EFFECT_REFRACTION", "EFFECT_DISPERSION", "CUBIC_INTERPOLATION"});
    subsets.push_back({"EFFECT_SCATTERING", "BAKED_LIGHT", "ISOTROPIC_SCATTERING"});
    subsets.push_back({"EFFECT_SCATTERING", "ANISOTROPY_BY_BAND", "BAKED_LIGHT"});
    subsets.push_back({"EFFECT_SCATTERING", "EFFECT_OPAQUE", "ANISOTROPY_BY_BAND", "BAKED_LIGHT", "LIGHT_LOBES", "INSETS"});
    for (const char* kernel : {"viewer/accumulate.comp.glsl", "viewer/count.comp.glsl"}) {
        rows.push_back({kernel, {}});
        rows.push_back({kernel, {"EFFECT_REFRACTION", "EFFECT_DISPERSION"}});
    }
    for (const auto& subset : subsets) {
        for (const char* kernel : {"viewer/march.comp.glsl", "viewer/march_on.comp.glsl"}) {
            rows.push_back(test::variant(kernel, subset, {"SAMPLES_PER_HALF 0"}));
            rows.push_back(test::variant(kernel, subset, {"SAMPLES_PER_HALF 2"}));
        }
        rows.push_back(test::variant("viewer/shade.comp.glsl", subset));
        rows.push_back(test::variant("viewer/reflect.comp.glsl", subset));
        rows.push_back(test::variant("viewer/generate.comp.glsl", subset));
        rows.push_back(test::variant("viewer/generate.comp.glsl", subset, {"RAYS_GIVEN"}));
        rows.push_back(test::variant("viewer/generate.comp.glsl", subset, {"LENS"}));
    }
    for (const std::vector<std::string>& alone :
         {std::vector<std::string>{}, {"EFFECT_DISPERSION"}, {"CUBIC_INTERPOLATION"}, {"STRAIGHT_FLIGHTS"},
          {"EFFECT_DISPERSION", "DISPERSION_BY_REFRACTIVITY", "STRAIGHT_FLIGHTS"}, {"MANUAL_FILTERING"}}) {
        rows.push_back(test::variant("viewer/march_freely.comp.glsl",
                                     {"EFFECT_REFRACTION", "SAMPLES_PER_HALF 0"}, alone));
    }
    for (const std::vector<std::string>& alone :
         {std::vector<std::string>{}, {"CUBIC_INTERPOLATION"}, {"STRAIGHT_FLIGHTS"}, {"MANUAL_FILTERING"}}) {
        for (const std::vector<std::string>& behind : {std::vector<std::string>{}, {"EFFECT_ENVIRONMENT"},
                                                       {"EFFECT_ENVIRONMENT", "ENVIRONMENT_IMAGE"}}) {
            const auto drawn = test::variant("viewer/draw_freely.comp.glsl", {"EFFECT_REFRACTION", "SAMPLES_PER_HALF 0"}, alone);
            const auto onward = test::variant(drawn.kernel, drawn.defines, behind);
            rows.push_back(onward);
            rows.push_back(test::variant(onward.kernel, onward.defines, {"BEGIN_RAYS", "BLOCKS_IN_TURN 1"}));
            rows.push_back(test::variant(onward.kernel, onward.defines, {"BEGIN_RAYS", "BLOCKS_IN_TURN 4", "LENS"}));
        }
    }
    for (const char* integrator : {"INTEGRATOR_EULER", "INTEGRATOR_RK4", "INTEGRATOR_SHARMA"}) {
        rows.push_back(test::variant("viewer/march.comp.glsl", switches, {integrator, "SAMPLES_PER_HALF 2"}));
        rows.push_back(test::variant("viewer/march_on.comp.glsl", switches, {integrator, "SAMPLES_PER_HALF 2"}));
        rows.push_back(test::variant("viewer/march.comp.glsl", {"EFFECT_REFRACTION", "CUBIC_INTERPOLATION"},
                                     {integrator, "SAMPLES_PER_HALF 0"}));
    }
    for (const std::vector<std::string>& look : std::vector<std::vector<std::string>>{
             {"TONE_AGX"}, {"TONE_REINHARD"}, {"LOOK_RADIANCE"}, {"LOOK_STEPS"}, {"LOOK_SLICE"},
             {"LOOK_SLICE", "LOOK_DIRECTION"}, {"LOOK_SLICE", "LOOK_INDEX"}, {"LOOK_ERROR"}}) {
        rows.push_back(test::variant("viewer/picture.comp.glsl", look));
        rows.push_back(test::variant("viewer/picture.comp.glsl", look, {"EFFECT_REFRACTION", "BAKED_LIGHT"}));
        rows.push_back(test::variant("viewer/picture.comp.glsl", look, {"BAKED_LIGHT", "MANUAL_FILTERING"}));
        rows.push_back(test::variant("viewer/picture.comp.glsl", look, {"EFFECT_REFRACTION", "INSETS"}));
    }
    return rows;
}

TEST(Kernels, CompileInEveryVariant) { test::expectVariantsCompile(variants()); }

TEST(Kernels, SatisfyTheValidatorInEveryVariant) { test::expectValidatorAgrees(variants()); }

TEST(Kernels, IncludeEveryFileOnce) {
    const std::string source = gpu::kernelSource("viewer/march.comp.glsl", {"EFFECT_REFLECTION", "SAMPLES_PER_HALF 0"});
    EXPECT_EQ(source.rfind("#version 450 core\n", 0), 0u);
    const std::string once = "struct RayState {";
    const auto first = source.find(once);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(source.find(once, first + 1), std::string::npos);
    EXPECT_EQ(source.find("#include"), std::string::npos);
    EXPECT_THROW(gpu::kernelSource("viewer/none.comp.glsl", {}), std::logic_error);
}

TEST(GpuObjects, RefuseTexturesBeyondTheDevice) {
    const gpu::Context& context = test::sharedContext();
    const int size = context.limits().maxTexture3dSize + 1;
    try {
        gpu::Texture3D texture(context, gpu::TexelFormat::kR8, {size, 1, 1}, "optics");
        FAIL() << "a texture beyond the device was made";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadInput);
        EXPECT_NE(std::string(error.what()).find(std::to_string(context.limits().maxTexture3dSize)), std::string::npos);
    }
}

TEST(GpuObjects, ReportErrorsOfTheDevice) {
    const gpu::Context& context = test::sharedContext();
    glBindTextureUnit(0, 0x7fffffffu);
    EXPECT_THROW(context.throwIfError(), Error);
    EXPECT_NO_THROW(context.throwIfError());
}

TEST(GpuObjects, MoveAndHoldNothing) {
    const gpu::Context& context = test::sharedContext();
    gpu::Buffer empty(context, 0, "empty");
    EXPECT_TRUE(empty.download<float>(0).empty());
    gpu::Buffer words(context, 16, "words");
    words.fill(7);
    gpu::Buffer moved = std::move(words);
    EXPECT_EQ(moved.download<std::uint32_t>(4), std::vector<std::uint32_t>(4, 7u));
    context.throwIfError();
}

TEST(GpuFields, UploadOnlyWhatEffectsNeed) {
    const Lattice lattice = test::cube(8, 1.0);
    Fields fields = test::uniformFields(lattice);
    const Scene scene;
    EXPECT_TRUE(GpuFields(test::sharedContext(), fields, test::effectsOf(scene, fields)).textures().empty());
    fields.sigmaA = DenseGrid<glm::vec3>(lattice.size, glm::vec3(1.0f));
    const GpuFields absorbing(test::sharedContext(), fields, test::effectsOf(scene, fields));
    ASSERT_EQ(absorbing.textures().size(), 1u);
    EXPECT_EQ(absorbing.textures()[0].first, "sigma_a");
    EXPECT_EQ(absorbing.textures()[0].second, 8u * 8 * 8 * 4) << "grey: one channel";
    fields.sigmaA.values.front() = glm::vec3(1.0f, 1.0f, 2.0f);
    const GpuFields coloured(test::sharedContext(), fields, test::effectsOf(scene, fields));
    EXPECT_EQ(coloured.textures()[0].second, 8u * 8 * 8 * 16);
}

} // namespace
} // namespace eikonal

// Every variant of every kernel of the viewer compiles, and the validator of the shading language agrees.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "common/error.h"
#include "common/gpu/objects.h"
#include "common/gpu/shader_source.h"
#include "common/gpu_fields.h"
#include "tests/viewer/synthetic_fields.h"

namespace eikonal {
namespace {

using Defines = std::vector<std::string>;

struct Variant {
    std::string kernel;
    Defines defines;
};

/// Every subset of what a kernel asks for would be 2^9; each effect alone, each left out, none and all say as much.
std::vector<Defines> effectSubsets() {
    const Defines all = {"EFFECT_REFRACTION", "EFFECT_ABSORPTION", "EFFECT_SCATTERING",  "EFFECT_EMISSION",
                         "EFFECT_REFLECTION", "EFFECT_OPAQUE",     "EFFECT_ENVIRONMENT", "ENVIRONMENT_IMAGE",
                         "BAKED_LIGHT",       "MANUAL_FILTERING"};
    std::vector<Defines> subsets = {{}, all};
    for (std::size_t i = 0; i < all.size(); ++i) {
        subsets.push_back({all[i]});
        Defines without = all;
        without.erase(without.begin() + std::ptrdiff_t(i));
        subsets.push_back(without);
    }
    return subsets;
}

std::vector<Variant> variants() {
    std::vector<Variant> rows = {{"viewer/accumulate.comp.glsl", {}},
                                 {"viewer/tone_map.comp.glsl", {}},
                                 {"viewer/tone_map.comp.glsl", {"TONE_AGX"}},
                                 {"viewer/tone_map.comp.glsl", {"TONE_REINHARD"}},
                                 {"gpu/linear_filtering.comp.glsl", {}}};
    for (const Defines& subset : effectSubsets()) {
        for (const char* extra : {"SAMPLES_PER_HALF 0", "SAMPLES_PER_HALF 2"}) {
            rows.push_back({"viewer/march.comp.glsl", subset});
            rows.back().defines.push_back(extra);
        }
        rows.push_back({"viewer/shade.comp.glsl", subset});
        rows.push_back({"viewer/generate.comp.glsl", subset});
        rows.push_back({"viewer/generate.comp.glsl", subset});
        rows.back().defines.push_back("RAYS_GIVEN");
    }
    return rows;
}

TEST(Kernels, CompileInEveryVariant) {
    const gpu::Context& context = test::sharedContext();
    for (const Variant& variant : variants()) {
        EXPECT_NO_THROW(gpu::Kernel(context, variant.kernel, variant.defines)) << variant.kernel;
    }
    EXPECT_NO_THROW(context.throwIfError());
}

TEST(Kernels, SatisfyTheValidatorInEveryVariant) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "glslangValidator is absent";
    const auto folder = std::filesystem::temp_directory_path() / ("eikonal_kernels_" + std::to_string(std::rand()));
    std::filesystem::create_directories(folder);
    std::string command = "glslangValidator -S comp";
    int number = 0;
    for (const Variant& variant : variants()) {
        const auto file = folder / (std::to_string(number++) + ".comp");
        std::ofstream(file) << gpu::kernelSource(variant.kernel, variant.defines);
        command += " " + file.string();
    }
    EXPECT_EQ(std::system((command + " > " + (folder / "log").string() + " 2>&1").c_str()), 0)
        << std::ifstream(folder / "log").rdbuf();
    std::filesystem::remove_all(folder);
}

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
    EXPECT_EQ(absorbing.textures()[0].second, 8u * 8 * 8 * 16);
}

} // namespace
} // namespace eikonal

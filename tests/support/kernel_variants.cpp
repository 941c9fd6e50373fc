#include "tests/support/kernel_variants.h"

#include <cstdlib>

#include "common/gpu/objects.h"
#include "common/gpu/shader_source.h"
#include "tests/support/synthetic_fields.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {

namespace {

std::string described(const KernelVariant& variant) {
    std::string text = variant.kernel;
    for (const std::string& define : variant.defines) text += " " + define;
    return text;
}

} // namespace

std::vector<std::vector<std::string>> tellingSubsets(const std::vector<std::string>& switches) {
    std::vector<std::vector<std::string>> subsets = {{}, switches};
    for (std::size_t i = 0; i < switches.size(); ++i) {
        subsets.push_back({switches[i]});
        auto without = switches;
        without.erase(without.begin() + std::ptrdiff_t(i));
        subsets.push_back(without);
    }
    return subsets;
}

KernelVariant variant(const std::string& kernel, std::vector<std::string> defines,
                      const std::vector<std::string>& more) {
    defines.insert(defines.end(), more.begin(), more.end());
    return {kernel, std::move(defines)};
}

void expectVariantsCompile(const std::vector<KernelVariant>& variants) {
    const gpu::Context& context = sharedContext();
    for (const KernelVariant& variant : variants) {
        EXPECT_NO_THROW(gpu::Kernel(context, variant.kernel, variant.defines)) << described(variant);
    }
    EXPECT_NO_THROW(context.throwIfError());
}

void expectValidatorAgrees(const std::vector<KernelVariant>& variants) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "glslangValidator is absent";
    const TemporaryFolder folder;
    std::string command = "cd " + folder.path().string() + " && glslangValidator -S comp";
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const std::string file = std::to_string(i) + ".comp";
        folder.write(file, gpu::kernelSource(variants[i].kernel, variants[i].defines));
        command += " " + file;
    }
    EXPECT_EQ(std::system((command + " > log 2>&1").c_str()), 0) << readText(folder / "log");
}

} // namespace eikonal::test

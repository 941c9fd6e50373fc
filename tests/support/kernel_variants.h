#pragma once
// The variants that kernels are compiled in, and what all of them must pass.

#include <string>
#include <vector>

namespace eikonal::test {

struct KernelVariant {
    std::string kernel;
    std::vector<std::string> defines;
};

/// Every subset of n switches would be 2^n; none, all, each alone and each left out say as much.
std::vector<std::vector<std::string>> tellingSubsets(const std::vector<std::string>& switches);

KernelVariant variant(const std::string& kernel, std::vector<std::string> defines,
                      const std::vector<std::string>& more = {});

/// Expects that the device compiles and links every variant.
void expectVariantsCompile(const std::vector<KernelVariant>& variants);

/// Expects that the validator of the shading language accepts the text of every variant; skips the test without it.
void expectValidatorAgrees(const std::vector<KernelVariant>& variants);

} // namespace eikonal::test

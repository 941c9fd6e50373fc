// Property tests. In CI: a few fixed seeds. For as long as one likes, from any seed:
//   test_properties --seed 1000 --minutes 60
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "tests/stability/properties.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal {
namespace {

constexpr std::uint64_t kSeedsInCi = 12;

std::uint64_t firstSeed = 1;
double minutes = 0.0;

/// Calls check(seed) for the seeds of CI, or until the time is over.
template <class Check>
void forEachSeed(const Check& check) {
    const auto start = std::chrono::steady_clock::now();
    const auto isOver = [&](std::uint64_t done) {
        const std::chrono::duration<double, std::ratio<60>> passed = std::chrono::steady_clock::now() - start;
        return minutes > 0.0 ? passed.count() >= minutes : done >= kSeedsInCi;
    };
    for (std::uint64_t done = 0; !isOver(done) && !testing::Test::HasFailure(); ++done) check(firstSeed + done);
}

TEST(Properties, ScenesByChanceAreSound) { forEachSeed(test::expectSceneProperties); }

TEST(Properties, RaysThroughSmoothFieldsComeBack) { forEachSeed(test::expectRayProperties); }

} // namespace
} // namespace eikonal

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--seed") == 0) {
            eikonal::firstSeed = std::strtoull(argv[i + 1], nullptr, 10);
        } else if (std::strcmp(argv[i], "--minutes") == 0) {
            eikonal::minutes = std::strtod(argv[i + 1], nullptr);
        } else {
            std::cerr << "usage: test_properties [--seed N] [--minutes M]     M minutes each of scenes and of rays\n";
            return 2;
        }
    }
    return RUN_ALL_TESTS();
}

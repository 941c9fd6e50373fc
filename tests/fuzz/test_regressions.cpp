// Inputs that once went wrong, and the fuzzers' seeds, by the functions that are fuzzed.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/fuzz/intakes.h"
#include "tests/support/temporary_folder.h"

namespace eikonal {
namespace {

using Intake = void (*)(fuzz::Bytes);

/// Expects no crash and no other exception than those that the intake takes for bad input.
void expectSurvives(const std::string& kind, Intake intake) {
    int inputs = 0;
    for (const char* folder : {"corpus", "regressions"}) {
        const auto path = std::filesystem::path(EIKONAL_FUZZ_FOLDER) / folder / kind;
        if (!std::filesystem::exists(path)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            const std::string bytes = test::readText(entry.path());
            SCOPED_TRACE(entry.path().string());
            EXPECT_NO_THROW(intake({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
            ++inputs;
        }
    }
    EXPECT_GT(inputs, 0) << "no inputs for " << kind;
}

TEST(FuzzRegressions, Scenes) { expectSurvives("scene", fuzz::readScene); }
TEST(FuzzRegressions, VdbFiles) { expectSurvives("vdb", fuzz::readVdbFile); }
TEST(FuzzRegressions, VdbAnswers) { expectSurvives("transfer", fuzz::receiveVdbAnswer); }
TEST(FuzzRegressions, Meshes) { expectSurvives("mesh", fuzz::readMesh); }

} // namespace
} // namespace eikonal

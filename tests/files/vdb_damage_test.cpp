// Damaged VDB files: a message, whatever OpenVDB does with them. Seeds are fixed, so that each run sees the same files.

#include "common/vdb_io.h"

#include <cmath>
#include <random>

#include <nlohmann/json.hpp>

#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

std::string intactFile(const TemporaryFolder& folder) {
    const Lattice lattice{{-1.0, -1.0, -1.0}, 2.0 / 24, {24, 24, 24}};
    DenseGrid<float> ior(lattice.size, 1.0f);
    DenseGrid<glm::vec3> absorption(lattice.size, glm::vec3(0.0f));
    for (std::size_t i = 0; i < ior.values.size(); ++i) {
        ior.values[i] = 1.0f + 0.5f * std::abs(std::sin(0.1f * float(i)));
        absorption.values[i] = glm::vec3(ior.values[i]);
    }
    writeVdb(folder / "intact.vdb", lattice, {{"ior", &ior, glm::vec3(1.0f)}, {"absorption", &absorption}}, {});
    return readText(folder / "intact.vdb");
}

/// Either the file reads, or it is called bad input; nothing else may happen.
bool readsOrComplains(const std::filesystem::path& path) {
    try {
        readVdb(path);
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(ExitCode::kBadInput)) << error.what();
        EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
        return false;
    }
}

TEST(VdbDamage, SaysWhatIsMissing) {
    const TemporaryFolder folder;
    expectError(ExitCode::kBadInput, "no such file", [&] { readVdb(folder / "none.vdb"); });
    expectError(ExitCode::kBadInput, "folder", [&] { readVdb(folder.path()); });
    writeText(folder / "empty.vdb", "");
    expectError(ExitCode::kBadInput, "empty", [&] { readVdb(folder / "empty.vdb"); });
    expectError(ExitCode::kBadInput, "empty", [&] { vdbSummary(folder / "empty.vdb"); });
    writeText(folder / "text.vdb", "v 0 0 0\nv 1 0 0\nThis is not a volume but some lines of text.\n");
    expectError(ExitCode::kBadInput, "text.vdb", [&] { readVdb(folder / "text.vdb"); });
    expectError(ExitCode::kBadInput, "text.vdb", [&] { vdbSummary(folder / "text.vdb"); });
}

TEST(VdbDamage, TruncatedFilesAreBadInput) {
    const TemporaryFolder folder;
    const std::string bytes = intactFile(folder);
    for (const double part : {0.0005, 0.002, 0.01, 0.1, 0.5, 0.9, 0.999}) {
        writeText(folder / "cut.vdb", bytes.substr(0, std::size_t(double(bytes.size()) * part)));
        EXPECT_FALSE(readsOrComplains(folder / "cut.vdb")) << "cut at " << part;
    }
}

TEST(VdbDamage, FlippedBitsNeverCrash) {
    const TemporaryFolder folder;
    const std::string bytes = intactFile(folder);
    std::mt19937 random(7);
    int complaints = 0;
    for (int i = 0; i < 60; ++i) {
        std::string damaged = bytes;
        // Half of the flips in the first 2 KiB, where headers and trees are.
        const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(2048, bytes.size()) : bytes.size();
        const std::size_t at = random() % range;
        damaged[at] = char(damaged[at] ^ char(1u << random() % 8));
        writeText(folder / "flipped.vdb", damaged);
        complaints += !readsOrComplains(folder / "flipped.vdb");
    }
    EXPECT_GT(complaints, 0) << "flips in the header must be noticed";
}

} // namespace
} // namespace eikonal::test

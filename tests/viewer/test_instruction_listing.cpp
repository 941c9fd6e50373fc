// Instructions of a kernel, as far as the driver lists them.
#include "common/gpu/instruction_listing.h"
#include "common/gpu/objects.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal {
namespace {

using gpu::listedInstructions;

TEST(InstructionListing, CountsStatementsThatDoSomething) {
    const std::string binary = std::string("\x01\0\x7fjunk;\n", 9) +
                               "!!NVcp5.0\nOPTION NV_internal;\nGROUP_SIZE 64;\nSTORAGE sbo_buf0[] = { program.storage[0] };\n"
                               "TEMP R0, R1;\nLONG TEMP D0;\nLDB.U32 R0.x, sbo_buf0[12];\nIF NE.x;\nMOV.U R1, R0;\nELSE;\nENDIF;\nEND\n" +
                               "MOV.U R0, R1;\n";
    EXPECT_EQ(listedInstructions(binary), 5u);
}

TEST(InstructionListing, IsNothingWhereThereIsNone) {
    EXPECT_EQ(listedInstructions(""), std::nullopt);
    EXPECT_EQ(listedInstructions("MOV.U R0, R1;\nEND\n"), std::nullopt);
    EXPECT_EQ(listedInstructions("!!NVcp5.0\nMOV.U R0, R1;\n"), std::nullopt);
}

TEST(InstructionListing, OfALargerKernelIsLonger) {
    const gpu::Kernel probe(test::sharedContext(), "gpu/linear_filtering.comp.glsl", {});
    const gpu::Kernel toneMap(test::sharedContext(), "viewer/tone_map.comp.glsl", {"TONE_AGX"});
    if (!probe.instructions()) GTEST_SKIP() << "this driver lists no instructions";
    EXPECT_GT(*probe.instructions(), 0u);
    EXPECT_GT(toneMap.instructions().value(), *probe.instructions());
}

} // namespace
} // namespace eikonal

// Buffers: what goes up comes back, in the order of commands, whatever its size.
#include <numeric>

#include "common/gpu/objects.h"
#include "tests/support/synthetic_fields.h"
#include "tests/support/temporary_folder.h"

namespace eikonal {
namespace {

std::vector<std::uint32_t> numbersFrom(std::uint32_t first, std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

TEST(Buffer, GivesBackWhatItGotWhateverItsSize) {
    // a word, a page, and more than what is on its way at a time, several times over
    for (const std::size_t count : {std::size_t(1), std::size_t(1024), std::size_t(5'000'003)}) {
        const auto numbers = numbersFrom(7, count);
        gpu::Buffer buffer(test::sharedContext(), (count + 3) * sizeof(std::uint32_t), "numbers");
        buffer.fill(5);
        buffer.uploadBytes(2 * sizeof(std::uint32_t), numbers.data(), count * sizeof(std::uint32_t));
        const auto found = buffer.download<std::uint32_t>(count + 3);
        EXPECT_EQ(std::vector(found.begin() + 2, found.end() - 1), numbers);
        EXPECT_EQ(found[0], 5u);
        EXPECT_EQ(found[1], 5u);
        EXPECT_EQ(found.back(), 5u);
    }
}

TEST(Buffer, KeepsWhatItHoldsWhenItGrows) {
    const auto numbers = numbersFrom(3, 100);
    gpu::Buffer buffer(test::sharedContext(), 100 * sizeof(std::uint32_t), "numbers");
    buffer.upload(std::span<const std::uint32_t>(numbers));
    buffer.grow(1000 * sizeof(std::uint32_t));
    EXPECT_EQ(buffer.bytes(), 1000 * sizeof(std::uint32_t));
    EXPECT_EQ(buffer.download<std::uint32_t>(100), numbers);
    buffer.grow(10);
    EXPECT_EQ(buffer.bytes(), 1000 * sizeof(std::uint32_t));
}

TEST(Buffer, IsNotOverwrittenBeforeKernelsHaveReadIt) {
    const test::TemporaryFolder folder;
    folder.write("copy.comp.glsl", "layout(local_size_x = 1) in;\n"
                                   "layout(std430, binding = 0) readonly buffer From { uint from[]; };\n"
                                   "layout(std430, binding = 1) buffer To { uint count; uint to[]; };\n"
                                   "void main() { to[count] = from[from.length() - 1]; ++count; }\n");
    constexpr std::uint32_t kRounds = 200;
    std::vector<std::uint32_t> found;
    {
        const gpu::Context context = gpu::Context::windowless({.forceManualFiltering = true, .shaderFolder = folder.path()});
        const gpu::Kernel copy(context, "copy.comp.glsl", {});
        gpu::Buffer from(context, 32768 * sizeof(std::uint32_t), "from");
        gpu::Buffer to(context, (kRounds + 1) * sizeof(std::uint32_t), "to");
        to.fill(0);
        for (std::uint32_t round = 0; round < kRounds; ++round) {
            from.upload(std::span<const std::uint32_t>(std::vector(32768, round)));
            from.bindStorage(0);
            to.bindStorage(1);
            copy.dispatch({1, 1, 1});
        }
        found = to.download<std::uint32_t>(kRounds + 1);
    }
    test::sharedContext().makeCurrent();
    std::vector<std::uint32_t> expected = numbersFrom(0, kRounds);
    expected.insert(expected.begin(), kRounds);
    EXPECT_EQ(found, expected);
}

} // namespace
} // namespace eikonal

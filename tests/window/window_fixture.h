#pragma once
// The program with a window on a virtual screen, driven by recordings.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/image_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

/// Of radiances of about 1: the window's camera has been through a turn in double precision, and float rays through glass
/// amplify the last bit of its position.
inline constexpr double kStillTolerance = 1e-3;

class WindowTest : public ::testing::Test {
protected:
    void SetUp() override;

    /// `more`: arguments; `options.launcher` comes between the virtual screen and the program.
    RunResult view(const std::string& script, const std::vector<std::string>& more = {}, RunOptions options = {}) const;
    /// Whatever ends well says nothing on stderr but a warning of what the script asks for `inVain`, if anything.
    void expectGood(const std::string& script, const std::vector<std::string>& more = {}, const std::string& inVain = {}) const;
    /// Replaces files by others as soon as the screenshot that stands for each is there.
    struct Replacement {
        std::string screenshot, file, text;
    };
    void expectGoodWhileReplacing(const std::vector<Replacement>& replacements, const std::string& script,
                                  const std::vector<std::string>& more = {}, const std::string& inVain = {}) const;

    ChannelImage still(int number) const;
    ChannelImage rendered(const std::vector<std::string>& more = {}) const;

    TemporaryFolder folder;
    std::string scene;
};

double rmsDifference(const ChannelImage& a, const ChannelImage& b);
/// Of linear values.
double rmsDifference(const Image& a, const Image& b);
/// Sum of the channels, over the picture.
double meanOf(const std::string& png);
/// Pixels in the colour of a message that says what is wrong.
int errorPixels(const std::string& png);

/// Waits, and saves the refined picture as still.
extern const std::string kSave;
extern const std::string kWithoutPanels;

} // namespace eikonal::test

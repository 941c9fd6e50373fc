// What the window shows after each of the things that a person may do, beside baselines (tests/window/baselines).
// EIKONAL_WRITE_BASELINES=1 in the environment writes them anew: look at them before they are kept.
#include <cstdlib>
#include <filesystem>

#include "tests/window/window_fixture.h"

namespace eikonal::test {
namespace {

// RMS of linear values. Vectors of another width and another order of additions move the last bits of a ray, and with it the
// edge of what it sees by a pixel here and there; nobody sees a hundredth of white.
constexpr double kBaselineTolerance = 0.01;

/// The same with a rectangle at the upper left corner blackened: numbers that tell times.
Image masked(Image image, const glm::ivec2& corner) {
    for (int y = 0; y < std::min(corner.y, image.size.y); ++y) {
        for (int x = 0; x < std::min(corner.x, image.size.x); ++x) {
            image.pixels[std::size_t(y) * std::size_t(image.size.x) + std::size_t(x)] = glm::vec3(0.0f);
        }
    }
    return image;
}

class WindowPictures : public WindowTest {
protected:
    std::filesystem::path baseline(const std::string& name) const {
        return std::filesystem::path(EIKONAL_BASELINES) / (name + ".png");
    }

    /// Ends the script with a picture of what is there when all is refined.
    void expectBaseline(const std::string& name, const std::string& script, const glm::ivec2& maskedCorner = glm::ivec2(0)) {
        const std::string shot = folder.file("shot.png");
        expectGood(script + "20 wait\n21 screenshot shot.png\n22 quit\n");
        if (std::getenv("EIKONAL_WRITE_BASELINES")) {
            std::filesystem::copy_file(shot, baseline(name), std::filesystem::copy_options::overwrite_existing);
        }
        const Image seen = masked(readImage(shot), maskedCorner);
        EXPECT_LT(rmsDifference(seen, masked(readImage(baseline(name)), maskedCorner)), kBaselineTolerance) << name;
    }
};

const std::string kStart = "0 key tab down\n0 key tab up\n0 wait\n1 cursor 159 119\n1 button right down\n1 button right up\n";

std::string presses(const char* key, int times) {
    std::string script;
    for (int i = 0; i < times; ++i) script += std::string("2 key ") + key + " down\n2 key " + key + " up\n";
    return script;
}

const std::string kOrbit = "2 cursor 80 60\n3 button left down\n4 cursor 110 90\n5 button left up\n";

TEST_F(WindowPictures, Orbited) { expectBaseline("orbited", kStart + kOrbit); }

TEST_F(WindowPictures, MinimisedAndRestored) { expectBaseline("orbited", kStart + kOrbit + "6 minimise\n9 restore\n"); }

TEST_F(WindowPictures, LightDragged) {
    // The beam comes along x: its lamp waits at the picture's left edge.
    expectBaseline("light_dragged", kStart + "2 cursor 6 60\n3 button left down\n4 cursor 40 20\n5 button left up\n");
}

TEST_F(WindowPictures, EffectSwitchedOff) {
    expectBaseline("effect_off", kStart + "2 set render.effects=[\"scattering\", \"environment\"]\n");
}

TEST_F(WindowPictures, FileDropped) {
    const std::string other = folder.write("other.toml", "[domain]\nresolution = 16\n[[object]]\nradius = 0.7\nior = 1.3\n");
    expectBaseline("dropped", kStart + "2 drop " + other + "\n");
}

TEST_F(WindowPictures, Resized) { expectBaseline("resized", kStart + "2 size 200 100\n"); }

TEST_F(WindowPictures, SeenAlongTheAxes) {
    expectBaseline("from_right", kStart + presses("3", 1));
    expectBaseline("from_above", kStart + presses("7", 1));
}

TEST_F(WindowPictures, WaysToLook) {
    int presses_ = 0;
    for (const char* name : {"radiance", "steps", "irradiance", "direction", "index", "error"}) {
        expectBaseline(std::string("look_") + name, kStart + presses("v", ++presses_));
    }
}

TEST_F(WindowPictures, IrradianceThatIsLookedAtBeforeThereIsAny) {
    const std::string early = "0 key tab down\n0 key tab up\n" + presses("v", 3) + "2 cursor 159 119\n";
    expectBaseline("look_irradiance", early + "3 button right down\n3 button right up\n");
}

TEST_F(WindowPictures, RaysOverThePicture) {
    expectBaseline("rays", "0 size 800 420\n" + presses("l", 1) + "3 cursor 340 400\n", {310, 420});
}

TEST_F(WindowPictures, Panels) { expectBaseline("panels", "0 size 800 420\n3 cursor 340 400\n", {310, 420}); }

TEST_F(WindowPictures, ListOfKeys) { expectBaseline("keys", "0 size 700 420\n" + presses("h", 1)); }

TEST_F(WindowPictures, TellTheStatesApart) {
    for (const auto& [one, other] : {std::pair{"orbited", "light_dragged"}, {"orbited", "effect_off"}, {"dropped", "effect_off"},
                                     {"look_radiance", "look_steps"}, {"look_irradiance", "look_direction"},
                                     {"look_index", "look_error"}, {"from_right", "from_above"}, {"rays", "panels"}}) {
        const Image a = masked(readImage(baseline(one)), {310, 420}), b = masked(readImage(baseline(other)), {310, 420});
        const bool masks = a.size.x > 310;
        EXPECT_GT(masks ? rmsDifference(a, b) : rmsDifference(readImage(baseline(one)), readImage(baseline(other))),
                  2.0 * kBaselineTolerance) << one << " and " << other;
    }
}

} // namespace
} // namespace eikonal::test

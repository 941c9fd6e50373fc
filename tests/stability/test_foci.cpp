// Foci: all the energy in a voxel, in a line, in a cusp; patches that shrink to nothing, turn inside out or become needles.
#include "tests/stability/hard_cases.h"

namespace eikonal {
namespace {

using test::expectSoundScene;

const std::string kLuneburg = "r < 1 ? sqrt(2 - r*r) : 1";

TEST(StableFoci, LuneburgLensGathersABeamInAVoxel) {
    const std::string scene = test::fieldInSmoke(kLuneburg, 1.2) + "[[light]]\n";
    for (const char* deposit : {"cells", "splat"}) {
        expectSoundScene(scene, {"domain.min=[-1.2, -1.2, -1.2]", "domain.max=[1.2, 1.2, 1.2]",
                                 std::string("accuracy.deposit='") + deposit + "'"});
    }
}

TEST(StableFoci, FishEyeGathersAllThatALampEmits) {
    // from (0.5, 0, 0) every ray comes to (-0.5, 0, 0), and goes on to where it began
    const std::string scene = test::fieldInSmoke("2/(1 + r*r/0.25)") + "[[light]]\ntype = 'point'\nposition = [0.5, 0, 0]\n";
    expectSoundScene(scene, {}, 0.03);
}

TEST(StableFoci, LineFocusOfACylinder) {
    const std::string cylinder = test::kSmoke + "[[object]]\nshape = 'cylinder'\nradius = 0.4\nheight = 3\nscattering = 0.3\n"
                                                "[[light]]\n";
    expectSoundScene(cylinder);
}

TEST(StableFoci, CuspsOfATiltedTorus) {
    const std::string torus = test::kSmoke + "[[object]]\nshape = 'torus'\nrotate = [30, 20, 10]\nscattering = 0.3\n[[light]]\n";
    expectSoundScene(torus);
}

TEST(StableFoci, FoldedPatchesGoOn) {
    const test::HardCase folded = test::bakedCase(test::kBallInSmoke, {"accuracy.deposit='splat'"});
    EXPECT_GT(folded.bake.statistics.patches.folds, 0u);  // they turn inside out behind the ball
    test::expectSound(folded, 0.08);  // hats of two voxels across a focus of two voxels: 5.3 %
    EXPECT_LE(folded.bake.statistics.energy.culled.x, 1e-3 * folded.bake.statistics.energy.entered.x);
}

TEST(StableFoci, NeedleThinPatches) {
    // a rectangle a million times longer than wide, a spot of a tenth of a degree, and a beam along a wall of glass
    expectSoundScene(test::kBallInSmoke + "type = 'rectangle'\nposition = [0, 0.9, 0]\nsize = [1e-6, 2]\nsamples = 2\n");
    expectSoundScene(test::kBallInSmoke + "type = 'spot'\nposition = [0, 0.9, 0]\nangle = 0.1\n", {}, 0.04);
    expectSoundScene(test::kSmoke + "[[object]]\nshape = 'box'\nsize = [3, 0.5, 3]\nscattering = 0.3\n[[light]]\n"
                                    "direction = [1, -0.001, 0]\n");
}

} // namespace
} // namespace eikonal

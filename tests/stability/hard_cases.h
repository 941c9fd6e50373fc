#pragma once
// Hard cases, from the text of a scene to its bake and picture by the program's own functions, and what all of them must keep.

#include <string>
#include <vector>

#include "lightsim/bake.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal::test {

struct HardCase {
    Scene scene;
    Fields fields;
    BakeResult bake;
};

/// A ball of glass in the even smoke of a box of ±1, 16 voxels along the edge; one beam along x. Every value is there to be
/// overridden: "object.0.ior=4". The smoke also fills the glass, so that light leaves power behind wherever it goes.
extern const std::string kBallInSmoke;

/// The same box and smoke without ball and light, to which a case adds its own.
extern const std::string kSmoke;

/// An expression of the index over a box of ±`half` in that smoke.
std::string fieldInSmoke(const std::string& ior, double half = 1.0);

HardCase bakedCase(const std::string& toml, const std::vector<std::string>& overrides = {});
RenderResult renderedCase(const HardCase& hard);

/// What the ledger of a bake may be out of balance by: the rounding of shares in single precision over thousands of steps.
/// Measured: 2.1e-6 at the most, with an index of 1e-5.
inline constexpr double kLedgerRounding = 1e-5;
/// What the grid may differ from the ledger by, of the power scattered. Measured for the ball: 2.0 % at these 16 voxels along the
/// edge, where its focus is two voxels wide, 0.1 % at 32.
inline constexpr double kGridShare = 0.03;

/// Expects finite, not negative irradiance, directions of at most unit length, no voxel with more than two crossings of it by
/// all the light, a ledger in balance, and a grid that says the same as the ledger within `gridShare`.
void expectSound(const HardCase& hard, double gridShare = kGridShare);

/// Expects values of the picture that are finite and not negative, and no ray that ended at the limit of steps.
void expectSound(const RenderResult& picture);

/// Both, of a scene.
void expectSoundScene(const std::string& toml, const std::vector<std::string>& overrides = {}, double gridShare = kGridShare);

} // namespace eikonal::test

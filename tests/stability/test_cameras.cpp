// Cameras where none belongs, and lenses from a needle to almost half of space.
#include "tests/stability/hard_cases.h"

namespace eikonal {
namespace {

void expectSoundFrom(const test::HardCase& lit, const Camera& camera) {
    test::HardCase seen = lit;
    seen.scene.camera = camera;
    test::expectSound(test::renderedCase(seen));
}

TEST(StableCameras, InGlassOnABoundaryInACaustic) {
    const test::HardCase lit = test::bakedCase(test::kBallInSmoke);
    const glm::dvec3 kPlaces[] = {{0.0, 0.0, 0.0},      // the ball's centre
                                  {0.1, 0.2, 0.05},     // in it
                                  {0.0, 0.0, 0.5},      // on its boundary
                                  {0.75, 0.0, 0.0},     // in the caustic
                                  {1.0, 0.0, 0.0},      // on a face
                                  {1.0, 1.0, 1.0},      // on a corner
                                  {0.0625, 0.0625, 0.0625}};  // a voxel's centre
    for (const glm::dvec3& place : kPlaces) {
        for (const glm::dvec3& towards : {glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.3, 0.5, 0.2)}) {
            SCOPED_TRACE(testing::Message() << "from (" << place.x << ", " << place.y << ", " << place.z << ")");
            expectSoundFrom(lit, {.position = place, .lookAt = place + towards});
        }
    }
}

TEST(StableCameras, FromOneDegreeToAHundredAndSeventy) {
    const test::HardCase lit = test::bakedCase(test::kBallInSmoke);
    for (const double fov : {1.0, 170.0, 179.0}) {
        expectSoundFrom(lit, {.position = {0.0, 0.0, 4.0}, .fov = fov});
        expectSoundFrom(lit, {.position = {0.1, 0.2, 0.05}, .lookAt = {1.0, 0.0, 0.0}, .fov = fov});
    }
}

TEST(StableCameras, ThatLookAlongUpOrAtThemselves) {
    const test::HardCase lit = test::bakedCase(test::kBallInSmoke);
    expectSoundFrom(lit, {.position = {0.0, 3.0, 0.0}, .lookAt = {0.0, 0.0, 0.0}});
    expectSoundFrom(lit, {.position = {0.0, 0.0, 3.0}, .lookAt = {0.0, 0.0, 3.0}});
    expectSoundFrom(lit, {.position = {0.0, 0.0, 1e6}, .lookAt = {0.0, 0.0, 0.0}, .fov = 1e-4});
}

} // namespace
} // namespace eikonal

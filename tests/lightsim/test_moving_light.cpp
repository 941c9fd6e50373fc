// Moving lights: a frame of a sequence is the bake of a scene with its lights there, to the last bit.
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Scene movingScene() {
    Scene scene;
    DirectionalLight sun{glm::normalize(glm::dvec3(1.0, 0.2, 0.0)), glm::dvec3(1.0), {}};
    sun.keyframes = {{.frame = 0.0, .direction = glm::dvec3(1.0, 0.0, 0.0)},
                     {.frame = 4.0, .direction = glm::dvec3(0.0, -1.0, 0.0)}};
    PointLight lamp{{0.0, 0.0, 0.0}, glm::dvec3(2.0), {}};
    // from outside the domain, where it is launched through a window, to the inside, where it is from a cube
    lamp.keyframes = {{.frame = 0.0, .position = glm::dvec3(3.0, 0.5, 0.0)},
                      {.frame = 2.0, .position = glm::dvec3(0.8, 0.5, 0.0)}};
    scene.lights = {sun, lamp};
    return scene;
}

TEST(MovingLight, AFrameIsTheBakeOfTheSceneWithTheLightsThere) {
    const Scene scene = movingScene();
    const Fields fields = test::absorbingSphereInSmoke(20);
    const EffectSet effects = decideEffects(scene, fields);
    LightSimulator simulator(test::sharedContext(), scene, fields, effects, {});
    const LightSet lights = lightsOf(scene, effects);
    std::vector<BakedLight> frames;
    for (int frame = 0; frame < 4; ++frame) {
        frames.push_back(simulator.bake(lightsAt(lights, frame)).light);
    }
    for (int frame = 0; frame < 4; ++frame) {
        Scene placed = scene;
        placed.lights = lightsAt(lights, frame).lights;
        const BakeResult alone = test::bake(placed, fields);
        EXPECT_EQ(frames[std::size_t(frame)].irradiance.values, alone.light.irradiance.values) << frame;
        EXPECT_EQ(frames[std::size_t(frame)].lightDirection.values, alone.light.lightDirection.values) << frame;
    }
    EXPECT_NE(frames[0].irradiance.values, frames[1].irradiance.values);
    EXPECT_NE(frames[2].irradiance.values, frames[3].irradiance.values) << "the sun goes on when the lamp has stopped";
}

TEST(MovingLight, APlainBakeIsFrame0) {
    const Fields fields = test::uniformFields(test::cube(12, 1.0));
    const BakeResult moving = test::bake(movingScene(), fields);
    Scene placed;
    placed.lights = {DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0), {}}, PointLight{{3.0, 0.5, 0.0}, glm::dvec3(2.0), {}}};
    EXPECT_EQ(moving.light.irradiance.values, test::bake(placed, fields).light.irradiance.values);
}

} // namespace
} // namespace eikonal

// Moving lights: a frame of a sequence is the bake of a scene with its lights there, to the last bit.
#include <array>
#include <string_view>

#include <epoxy/gl.h>

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

/// Kernels and textures on the device that `counts(kind, name)`.
template <class Counts>
int countObjects(const Counts& counts) {
    constexpr GLuint kNames = 4096;  // more than the tests of a process have at a time
    int count = 0;
    for (GLuint name = 1; name < kNames; ++name) {
        count += glIsProgram(name) && counts(GL_PROGRAM, name) ? 1 : 0;
        count += glIsTexture(name) && counts(GL_TEXTURE, name) ? 1 : 0;
    }
    return count;
}

bool isMarked(GLenum kind, GLuint name) {
    std::array<char, 64> label{};
    glGetObjectLabel(kind, name, GLsizei(label.size()), nullptr, label.data());
    return std::string_view(label.data()) == "marked";
}

bool mark(GLenum kind, GLuint name) {
    glObjectLabel(kind, name, -1, "marked");
    return isMarked(kind, name);
}

TEST(MovingLight, KernelsAndTexturesAreMadeOnce) {
    const Scene scene = movingScene();
    const Fields fields = test::absorbingSphereInSmoke(16);
    const EffectSet effects = decideEffects(scene, fields);
    LightSimulator simulator(test::sharedContext(), scene, fields, effects, {});
    const LightSet lights = lightsOf(scene, effects);
    simulator.bake(lightsAt(lights, 0.0));
    const int made = countObjects(mark);
    EXPECT_GT(made, 4);  // index, interface, sigma_a, sigma_s, and kernels
    simulator.bake(lightsAt(lights, 1.0));
    // a name may be given again after a deletion; a label that is still there says that the thing is
    EXPECT_EQ(countObjects(isMarked), made);
    EXPECT_EQ(countObjects([](GLenum, GLuint) { return true; }), made);
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

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SceneToml, SmallestSceneIsOneObjectOfGlass) {
    const Scene scene = sceneOf("[[object]]\n");
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_DOUBLE_EQ(std::get<SphereShape>(scene.objects[0].shape).radius, 0.5);
    EXPECT_DOUBLE_EQ(scene.objects[0].ior.constant.x, 1.5);
    EXPECT_EQ(scene.domain.resolution, 128);
    EXPECT_TRUE(scene.lights.empty());  // no [[light]] means no light
}

TEST(SceneToml, ReadsWhatTheFileSays) {
    const Scene scene = sceneOf(R"toml(
[domain]
min = [-2, -1, 0.5]
resolution = 64
ior = "1 + 0.1*exp(-y)"
[medium]
scattering = [0.1, 0.2, 0.3]
anisotropy = -0.5
[[object]]
name = "ring"
shape = "torus"
radius = 0.5
tube = 0.1
ior = "1.25"
smooth = 3
rotate = [0, 90, 0]
[[light]]
type = "point"
position = [1, 2, 3]
[[light]]
direction = [0, 0, 2]
[environment]
color = [1, 2, 3]
[accuracy]
step = 0.5
deposit = "splat"
[render]
effects = ["refraction", "environment"]
)toml");
    EXPECT_EQ(scene.domain.min, glm::dvec3(-2.0, -1.0, 0.5));
    EXPECT_EQ(scene.domain.ior.expression, "1 + 0.1*exp(-y)");
    EXPECT_EQ(scene.medium.scattering.constant, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_DOUBLE_EQ(std::get<TorusShape>(scene.objects[0].shape).tube, 0.1);
    EXPECT_TRUE(scene.objects[0].ior.isConstant());  // "1.25" is a number
    EXPECT_DOUBLE_EQ(scene.objects[0].ior.constant.x, 1.25);
    EXPECT_EQ(scene.objects[0].smoothVoxels, 3.0);
    EXPECT_EQ(std::get<PointLight>(scene.lights[0]).position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(std::get<DirectionalLight>(scene.lights[1]).direction, glm::dvec3(0.0, 0.0, 1.0));  // normalised
    EXPECT_EQ(scene.environment.gradient[0], glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(scene.environment.gradient[1], glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(scene.accuracy.stepVoxels, 0.5);
    EXPECT_EQ(scene.render.effects, (std::vector<std::string>{"refraction", "environment"}));
}

TEST(SceneToml, TransformTurnsAroundXThenYThenZAfterScaling) {
    const Scene scene = sceneOf("[[object]]\ntranslate = [1, 0, 0]\nrotate = [90, 90, 0]\nscale = 2\n");
    // Local y: scaled to 2 y, Rx turns it to 2 z, Ry turns z to x, then the shift.
    const glm::dvec4 world = scene.objects[0].worldFromLocal() * glm::dvec4(0.0, 1.0, 0.0, 1.0);
    EXPECT_NEAR(world.x, 3.0, 1e-12);
    EXPECT_NEAR(world.y, 0.0, 1e-12);
    EXPECT_NEAR(world.z, 0.0, 1e-12);
}

TEST(SceneToml, EveryShapeKeepsItsParametersOverAWrittenScene) {
    const std::string text = R"toml(
[[object]]
shape = "sphere"
radius = 0.123456789012345
absorption = "0.1 + r"
[[object]]
shape = "box"
size = [1, 2, 3]
smooth = false
[[object]]
shape = "rounded_box"
[[object]]
shape = "cylinder"
[[object]]
shape = "torus"
[[object]]
shape = "prism"
[[object]]
shape = "plane"
opaque = true
checker = [[0.9, 0.9, 0.9], [0.1, 0.1, 0.1], 0.5]
[[object]]
shape = "wine"
fill = 0.7
[[object]]
shape = "wine_glass"
name = "a \"quoted\" name"
[[object]]
shape = "field"
scattering = "exp(-r*r)"
[[light]]
direction = [1, 2, 3]
[[light]]
type = "point"
[environment]
gradient = [[1, 1, 1], [0.1, 0.2, 0.3]]
[render]
effects = []
)toml";
    const std::string once = resolvedToml(sceneOf(text));
    const std::string twice = resolvedToml(sceneOf(once));
    EXPECT_EQ(once, twice);
    EXPECT_TRUE(contains(once, "radius = 0.123456789012345\n"));
    EXPECT_TRUE(contains(once, "resolution = 128")) << "defaults are written";
    EXPECT_FALSE(sceneOf(once).objects.back().ior.given) << "a field without ior leaves the index as it is";
}

TEST(SceneToml, UnknownKeysNameTheNearest) {
    EXPECT_TRUE(contains(errorOf("[domain]\nresolutoin = 4\n"), "s.toml:2:")) << errorOf("[domain]\nresolutoin = 4\n");
    EXPECT_TRUE(contains(errorOf("[domain]\nresolutoin = 4\n"), "did you mean 'resolution'?"));
    EXPECT_TRUE(contains(errorOf("[domian]\n"), "did you mean 'domain'?"));
    EXPECT_TRUE(contains(errorOf("[[object]]\nshape = \"sphere\"\ntube = 1\n"), "unknown key 'tube' in object.0"));
    EXPECT_TRUE(contains(errorOf("[[object]]\nshape = \"shpere\"\n"), "did you mean 'sphere'?"));
    EXPECT_TRUE(contains(errorOf("[render]\neffects = [\"scatering\"]\n"), "did you mean 'scattering'?"));
    EXPECT_TRUE(contains(errorOf("[[light]]\nirradience = [1,1,1]\n"), "did you mean 'irradiance'?"));
    for (const std::string kind : {"volume", "mesh"}) {
        const std::string error = errorOf("[[object]]\n" + kind + " = \"a.vdb\"\nradius = 1\n");
        EXPECT_EQ(error.find("'" + kind + "'"), error.rfind("'" + kind + "'")) << "once: " << error;
    }
}

TEST(SceneToml, WrongValuesSayWhereWhatWasExpectedAndFound) {
    EXPECT_EQ(errorOf("[domain]\nresolution = 1.5\n"),
              "s.toml:2:14: domain.resolution: expected an integer from 1 to 4096, found number 1.5");
    for (const char* tolerance : {"0", "1", "1.5", "inf"}) {
        EXPECT_TRUE(contains(errorOf(std::string("[accuracy]\ntolerance = ") + tolerance + "\n"),
                             "s.toml:2:13: accuracy.tolerance: expected a number from 0 to 1, ends excluded, found ")) << tolerance;
    }
    EXPECT_TRUE(contains(errorOf("[[object]]\nsurface = \"rough\"\nroughness = 2\n"), "expected a number > 0 and <= 1, found integer 2"));
    EXPECT_EQ(errorOf("[[object]]\nradius = -1\n"),
              "s.toml:2:10: object.0.radius: expected a number > 0, found integer -1");
    EXPECT_EQ(errorOf("[camera]\nfov = \"wide\"\n").substr(0, 35), "s.toml:2:7: camera.fov: expected a ");
    for (const char* bad : {"[domain]\nmin = [nan, 0, 0]\n", "[domain]\nmin = [1, 2]\n", "[domain]\nsmooth = inf\n",
                            "[domain]\nior = 0\n", "[domain]\nior = \"-1\"\n", "[[object]]\nior = -1.5\n",
                            "[[object]]\nior = [1, 2, 3]\n", "[[object]]\nior = true\n", "[medium]\nanisotropy = 1\n",
                            "[medium]\nabsorption = -0.1\n", "[[object]]\nscale = 0\n", "[[object]]\nopaque = 1\n",
                            "[[object]]\nsmooth = \"no\"\n", "[[object]]\nanisotropy = [0.1, 0.2, 1]\n", "[medium]\nanisotropy = [0.1, 0.2]\n",
                            "[[light]]\ndirection = [0, 0, 0]\n", "[accuracy]\nstep = 0\n", "[render]\nsize = [0, 1]\n",
                            "[[object]]\nalbedo = [2, 0, 0]\n", "[[object]]\nsurface = \"dull\"\n",
                            "[[object]]\nroughness = 0\n", "[[object]]\nreflection_tint = [1, 1, 2]\n",
                            "[accuracy]\nintegrator = \"fast\"\n"})
        EXPECT_TRUE(contains(errorOf(bad), "s.toml:2:")) << bad << " -> " << errorOf(bad);
}

TEST(SceneToml, ValuesThatContradictEachOtherAreErrors) {
    EXPECT_TRUE(contains(errorOf("[domain]\nmin = [2, -1, -1]\n"), "expected max > min in x"));
    EXPECT_TRUE(contains(errorOf("[camera]\nposition = [0, 0, 0]\n"), "look_at away from position"));
    EXPECT_TRUE(contains(errorOf("[camera]\nup = [0, 0, 1]\n"), "up not along the view"));
    EXPECT_TRUE(contains(errorOf("[environment]\ncolor = [1,1,1]\ngradient = [[1,1,1],[1,1,1]]\n"),
                         "s.toml:1:1: environment: expected one of 'image', 'color' and 'gradient', found 'color' and 'gradient'"));
    EXPECT_TRUE(contains(errorOf("[[object]]\nshape = \"box\"\nmesh = \"a.ply\"\n"), "expected one of"));
    EXPECT_TRUE(contains(errorOf("[[object]]\nshape = \"rounded_box\"\nradius = 0.6\n"), "half the shortest edge"));
    EXPECT_TRUE(contains(errorOf("[object]\n"), "[[object]]"));
}

TEST(SceneToml, SyntaxErrorsAndBadExpressionsHaveAPosition) {
    EXPECT_TRUE(contains(errorOf("[domain\n"), "s.toml:1:")) << errorOf("[domain\n");
    EXPECT_TRUE(contains(errorOf("a = \x01\n"), "s.toml:1:"));
    // The quote stands in column 7, `foo` in column 12.
    EXPECT_TRUE(contains(errorOf("[[object]]\nior = \"1 + foo\"\n"), "s.toml:2:12")) << errorOf("[[object]]\nior = \"1 + foo\"\n");
}

TEST(SceneToml, FilesThatAreMissingAreErrorsAtTheirPosition) {
    for (const char* key : {"[[object]]\nmesh", "[[object]]\nvolume", "[environment]\nimage"}) {
        const std::string message = errorOf(std::string(key) + " = \"not_there.xyz\"\n");
        EXPECT_TRUE(contains(message, "s.toml:2:")) << message;
        EXPECT_TRUE(contains(message, "not_there.xyz")) << message;
    }
    EXPECT_TRUE(contains(messageOf([] { loadScene("not_there.toml"); }), "not_there.toml: expected a scene file"));
    EXPECT_TRUE(contains(messageOf([] { loadScene("."); }), "found a folder"));
}

TEST(SceneToml, OverridesReachEveryValue) {
    const std::string text = "[[object]]\nname = \"ball\"\n[[light]]\n";
    const Scene scene = sceneOf(text, {"domain.resolution=64", "object.0.radius=0.25", "object.ball.ior=1.4",
                                       "light.0.direction=[0, 1, 0]", "accuracy.integrator=rk4", "camera.fov = 20"});
    EXPECT_EQ(scene.domain.resolution, 64);
    EXPECT_DOUBLE_EQ(std::get<SphereShape>(scene.objects[0].shape).radius, 0.25);
    EXPECT_DOUBLE_EQ(scene.objects[0].ior.constant.x, 1.4);
    EXPECT_EQ(std::get<DirectionalLight>(scene.lights[0]).direction, glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(scene.accuracy.integrator, Integrator::kRk4);
    EXPECT_DOUBLE_EQ(scene.camera.fov, 20.0);
}

TEST(SceneToml, OverridesAreCheckedLikeTheFile) {
    const std::string text = "[[object]]\nname = \"ball\"\n";
    EXPECT_EQ(errorOf(text, {"domain.resolution=-1"}),
              "--set domain.resolution=-1: domain.resolution: expected an integer from 1 to 4096, found integer -1");
    EXPECT_TRUE(contains(errorOf(text, {"domain.resolutoin=4"}), "did you mean 'resolution'?"));
    EXPECT_TRUE(contains(errorOf(text, {"object.3.ior=1.4"}), "one of the scene's 1 object, found '3'"));
    EXPECT_TRUE(contains(errorOf(text, {"object.bell.ior=1.4"}), "one of the scene's 1 object, found 'bell'"));
    EXPECT_TRUE(contains(errorOf(text, {"light.0.power=[1,1,1]"}), "the scene has no 'light'"));
    EXPECT_TRUE(contains(errorOf(text, {"domian.min=[0, 0, 0]"}), "--set domian.min=[0, 0, 0]: unknown section 'domian', did you mean 'domain'?"));
    EXPECT_TRUE(contains(errorOf(text, {"domain"}), "wrong exit code")) << "usage, not input";
}

TEST(SceneToml, AnOverrideThatDoesNotFitTheFileIsNamedItself) {
    const std::string text = "[domain]\nmax = [2, 2, 2]\n[camera]\nfov = 30\n[accuracy]\ndeposit = \"auto\"\n[environment]\nrotate = 1\n"
                             "[[object]]\nshape = \"rounded_box\"\n[[object]]\nshape = \"torus\"\n";
    const auto begins = [&](const std::string& override, const std::string& what) {
        const std::string error = errorOf(text, {override});
        EXPECT_EQ(error.rfind("--set " + override + ": " + what, 0), 0u) << error;
    };
    begins("camera.up=[0, 0, 1]", "camera: ");
    begins("domain.min=[3, 3, 3]", "domain: ");
    begins("object.0.radius=0.6", "object.0.radius: ");
    begins("object.1.radius=0.1", "object.1.tube: ");
    EXPECT_EQ(errorOf(text + "[render]\n", {"render.samples=0"}).rfind("--set render.samples=0: ", 0), 0u);
    EXPECT_EQ(errorOf("", {"camera.up=[0, 0, 1]"}).rfind("--set camera.up=[0, 0, 1]: camera: ", 0), 0u);
    EXPECT_TRUE(contains(errorOf("[camera]\nup = [0, 0, 1]\n"), "s.toml:1:1: camera: ")) << "the file, if it is that";
}

TEST(SceneToml, ALookOfTheSkyThatIsSetTakesThePlaceOfTheOther) {
    const std::string text = "[environment]\ncolor = [1, 2, 3]\n";
    const Scene scene = sceneOf(text, {"environment.gradient=[[1, 1, 1], [2, 2, 2]]"});
    EXPECT_EQ(scene.environment.gradient[1], glm::dvec3(2.0));
    EXPECT_TRUE(contains(resolvedToml(sceneOf(text)), "color = [1, 2, 3]\n"));
    EXPECT_FALSE(contains(resolvedToml(sceneOf(text)), "gradient"));
    const Scene last = sceneOf(text, {"environment.gradient=[[1, 1, 1], [2, 2, 2]]", "environment.color=[4, 4, 4]"});
    EXPECT_EQ(last.environment.gradient[0], glm::dvec3(4.0));
}

TEST(SceneToml, ShippedScenesLoad) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(EIKONAL_SCENES)) {
        if (entry.path().extension() != ".toml")
            continue;
        ++count;
        const std::string message = messageOf([&] { loadScene(entry.path()); });
        // Meshes that a scene names may be made by a command first; everything else must be right.
        EXPECT_TRUE(message == "no error" || contains(message, "expected a file")) << message;
    }
    EXPECT_GT(count, 0);
}

} // namespace
} // namespace eikonal

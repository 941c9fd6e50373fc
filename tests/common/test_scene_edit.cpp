// A scene file with other values: it says them, and what its author wrote around them is still there.
#include <gtest/gtest.h>

#include "common/scene_edit.h"
#include "common/scene_toml.h"

namespace eikonal {
namespace {

const std::string kText = R"(# A lens in smoke: "été".

[domain]               # the room
resolution = 0x30      # hexadecimal, for a change

[[object]]
name = "bällchen"      # a name of more bytes than letters
ior    = 1.50          # crown
absorption = [ 0.1,
               0.2,    # green
               0.3 ]

# The lamp swings.
[[light]]
type = "point"
[[light.keyframe]]
frame = 0
position = [0, 1, 0]
[[light.keyframe]]
frame = 9
position = [0, 2, 0]

[render]
samples = 2)";

Scene sceneOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parseScene(text, "a.toml", ".", overrides);
}

std::string editedTo(const std::vector<std::string>& overrides) { return editedToml(kText, ".", sceneOf(kText, overrides)); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(SceneEdit, LeavesATextThatSaysItAlready) { EXPECT_EQ(editedTo({}), kText); }

TEST(SceneEdit, ReplacesAValueWhereItStands) {
    EXPECT_EQ(editedTo({"object.0.ior=1.7"}), replaced(kText, "1.50 ", "1.7 "));
    EXPECT_EQ(editedTo({"domain.resolution=64"}), replaced(kText, "0x30", "64"));
    EXPECT_EQ(editedTo({"object.0.name=ball"}), replaced(kText, "\"bällchen\"", "\"ball\""));
}

TEST(SceneEdit, ReplacesAnArrayOfSeveralLines) {
    const std::string edited = editedTo({"object.0.absorption=0.5"});
    EXPECT_EQ(edited, replaced(kText, kText.substr(kText.find("[ 0.1"), kText.find("0.3 ]") + 5 - kText.find("[ 0.1")), "0.5"));
}

TEST(SceneEdit, AddsAValueBehindTheOthersOfItsSection) {
    EXPECT_EQ(editedTo({"domain.smooth=2"}), replaced(kText, "for a change\n", "for a change\nsmooth = 2\n"));
    EXPECT_EQ(editedTo({"render.exposure=1"}), kText + "\nexposure = 1\n");
    EXPECT_EQ(editedTo({"light.0.power=[1, 2, 3]"}), replaced(kText, "\"point\"\n", "\"point\"\npower = [1, 2, 3]\n"));
}

TEST(SceneEdit, AddsASection) { EXPECT_EQ(editedTo({"camera.fov=50"}), kText + "\n\n[camera]\nfov = 50\n"); }

TEST(SceneEdit, RemovesTheKeyframesOfALightThatWasDragged) {
    Scene scene = sceneOf(kText);
    std::get<PointLight>(scene.lights[0]) = {.position = {1.0, 0.0, 0.0}, .power = glm::dvec3(10.0), .keyframes = {}};
    const std::string edited = editedToml(kText, ".", scene);
    EXPECT_EQ(edited.find("keyframe"), std::string::npos) << edited;
    EXPECT_NE(edited.find("# The lamp swings.\n[[light]]\ntype = \"point\"\nposition = [1, 0, 0]\n"), std::string::npos) << edited;
    EXPECT_EQ(resolvedToml(sceneOf(edited)), resolvedToml(scene));
}

TEST(SceneEdit, AddsValuesToTheLastTableAndTablesBehindIt) {
    const std::string text = "[[object]]\n[[light]]  # the sun\n";
    for (const std::string& ending : {std::string(), std::string("# the end"), std::string("# the end\n")}) {
        const std::vector<std::string> overrides{"light.0.irradiance=[9, 9, 9]", "camera.position=[1, 1, 3]", "medium.scattering=0.4",
                                                 "render.samples=9"};
        const std::string edited = editedToml(text + ending, ".", sceneOf(text + ending, overrides));
        EXPECT_EQ(edited.rfind("[[object]]\n[[light]]  # the sun\nirradiance = ", 0), 0u) << edited;
        EXPECT_NE(edited.find(ending), std::string::npos) << edited;
        EXPECT_EQ(resolvedToml(sceneOf(edited)), resolvedToml(sceneOf(text, overrides)));
    }
}

TEST(SceneEdit, KeepsTheSpellingOfTheSky) {
    const std::string text = "[environment]\ncolor = [0, 0, 0]  # night\n# stars?\n";
    EXPECT_EQ(editedToml(text, ".", sceneOf(text, {"environment.color=[1, 1, 1]"})), replaced(text, "[0, 0, 0]", "[1, 1, 1]"));
    const std::string gradient = editedToml(text, ".", sceneOf(text, {"environment.gradient=[[1, 1, 1], [0, 0, 1]]"}));
    EXPECT_EQ(gradient, "[environment]\ngradient = [[1, 1, 1], [0, 0, 1]]\n# stars?\n");
}

TEST(SceneEdit, SaysWhatItIsAskedToAfterManyChanges) {
    const std::vector<std::string> overrides{"object.0.ior=1.25", "object.0.absorption=0", "medium.scattering=0.4",
                                             "light.0.power=[7, 7, 7]", "render.samples=9", "render.effects=[\"refraction\"]",
                                             "accuracy.tolerance=0.1"};
    const std::string edited = editedTo(overrides);
    EXPECT_EQ(resolvedToml(sceneOf(edited)), resolvedToml(sceneOf(kText, overrides)));
    for (const char* comment : {"\"été\"", "# the room", "# crown", "# The lamp swings.", "# a name of more bytes"}) {
        EXPECT_NE(edited.find(comment), std::string::npos) << comment;
    }
}

TEST(SceneEdit, WritesAnewWhatCannotBeEdited) {
    const Scene scene = sceneOf(kText);
    EXPECT_EQ(editedToml("not a scene", ".", scene), resolvedToml(scene));
    EXPECT_EQ(editedToml("[[object]]\n[[object]]\n", ".", scene), resolvedToml(scene)) << "another number of objects";
    const std::string inlineTables = "domain = { resolution = 20 }\n";
    const Scene finer = sceneOf(inlineTables, {"domain.smooth=3"});
    EXPECT_EQ(resolvedToml(sceneOf(editedToml(inlineTables, ".", finer))), resolvedToml(finer));
}

} // namespace
} // namespace eikonal

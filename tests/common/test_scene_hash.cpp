#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <unistd.h>

#include "common/image_io.h"
#include "common/scene_hash.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

const std::string kText = "[domain]\nresolution = 10\n[[object]]\nname = \"ball\"\n[[light]]\n";

std::string hashWith(const std::vector<std::string>& overrides) {
    const Scene scene = sceneOf(kText, overrides);
    return sceneHash(scene, composeFields(scene));
}

TEST(SceneHash, CameraAndFilmDoNotMatter) {
    const std::string hash = hashWith({});
    EXPECT_EQ(hash.size(), 16u);
    EXPECT_EQ(hash, hashWith({}));
    for (const char* override : {"camera.fov=20", "render.size=[10, 10]", "render.exposure=1", "object.0.name=pearl",
                                 "environment.intensity=2"})
        EXPECT_EQ(hash, hashWith({override})) << override;
}

TEST(SceneHash, WhatTheBakeDependsOnDoes) {
    const std::string hash = hashWith({});
    for (const char* override : {"domain.resolution=11", "object.0.ior=1.4", "medium.absorption=0.1",
                                 "light.0.irradiance=[2, 1, 1]",
                                 "light.0.keyframe=[{ frame = 1, direction = [0, 1, 0] }]", "accuracy.tolerance=0.01",
                                 "render.effects=[\"refraction\"]", "environment.bake=true"})
        EXPECT_NE(hash, hashWith({override})) << override;
}

TEST(SceneHash, TintsMatterWhereLightIsFollowedAfterReflection) {
    const std::string tint = "object.0.reflection_tint=[1, 0.5, 0.5]", followed = "accuracy.reflections=1";
    EXPECT_EQ(hashWith({}), hashWith({tint}));
    EXPECT_NE(hashWith({followed}), hashWith({followed, tint}));
}

TEST(SceneHash, ResolvedSceneHashesTheSame) {
    const Scene scene = sceneOf(kText);
    const Scene again = sceneOf(resolvedToml(scene));
    EXPECT_EQ(sceneHash(scene, composeFields(scene)), sceneHash(again, composeFields(again)));
}

TEST(SceneHash, ContentsOfFieldsCount) {
    const Scene scene = sceneOf(kText);
    Fields fields = composeFields(scene);
    const std::string hash = sceneHash(scene, fields);
    fields.ior.values[17] += 1e-6f;
    EXPECT_NE(hash, sceneHash(scene, fields));
}

TEST(SceneHash, ContentsOfAnEnvironmentThatLightsTheBakeCount) {
    const auto folder = std::filesystem::temp_directory_path() / ("eikonal_hash_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const auto hashWithSky = [&](float radiance, const std::string& bake) {
        const std::vector<float> values(8 * 4, radiance);
        writeExr(folder / "sky.exr", {8, 4}, {{"R", &values}, {"G", &values}, {"B", &values}}, {});
        const Scene scene = parseScene("[environment]\nimage = \"sky.exr\"\nbake = " + bake + "\n", "a.toml", folder);
        return sceneHash(scene, composeFields(scene));
    };
    EXPECT_EQ(hashWithSky(1.0f, "true"), hashWithSky(1.0f, "true"));
    EXPECT_NE(hashWithSky(1.0f, "true"), hashWithSky(5.0f, "true"));
    EXPECT_EQ(hashWithSky(1.0f, "false"), hashWithSky(5.0f, "false"));
    std::filesystem::remove_all(folder);
}

TEST(SceneHash, NamesTheKeysThatDiffer) {
    const Scene scene = sceneOf(kText);
    const Scene other = sceneOf(kText, {"object.ball.ior=1.4", "domain.resolution=12", "camera.fov=10",
                                        "accuracy.step=0.5"});
    EXPECT_EQ(differingKeys(scene, other),
              (std::vector<std::string>{"domain.resolution", "object.0.ior", "accuracy.step"}));
    const Scene more = sceneOf(kText + "[[light]]\ntype = \"point\"\n");
    const std::vector<std::string> added = differingKeys(scene, more);
    EXPECT_NE(std::find(added.begin(), added.end(), "light.1.power"), added.end());
    EXPECT_TRUE(differingKeys(scene, scene).empty());
}

} // namespace
} // namespace eikonal

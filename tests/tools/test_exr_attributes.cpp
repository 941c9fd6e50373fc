// What the head of a rendered OpenEXR says, read from its bytes as the format defines them.
#include <array>
#include <cmath>
#include <cstring>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "common/image_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

/// A small pane of two voxels' width that shines a little right of and above the middle of a picture of 64 x 48 pixels.
const std::string kPane = R"([domain]
resolution = 32
[[object]]
shape = "box"
size = [0.125, 0.125, 0.125]
ior = 1.0
emission = 10.0
translate = [0.5, 0.3125, -0.1875]
[camera]
position = [0.4, 0.7, 4]
look_at = [0.1, 0.0, 0.2]
[environment]
color = [0, 0, 0]
[render]
size = [64, 48]
)";

/// The value of an attribute: its name, its type's name, the number of its bytes, and they. Empty where there is none.
std::string attribute(const std::string& exr, const std::string& name, const std::string& type) {
    const std::string start = name + '\0' + type + '\0';
    const std::size_t at = exr.find(start);
    if (at == std::string::npos) return {};
    std::int32_t bytes = 0;
    std::memcpy(&bytes, exr.data() + at + start.size(), 4);
    return exr.substr(at + start.size() + 4, std::size_t(bytes));
}

float number(const std::string& bytes) {
    float value = 0.0f;
    if (bytes.size() == 4) std::memcpy(&value, bytes.data(), 4);
    return value;
}

/// A row vector times a matrix of sixteen floats, row after row, over w.
glm::dvec3 transformed(const glm::dvec3& point, const std::string& bytes) {
    std::array<float, 16> m{};
    if (bytes.size() != sizeof m) return glm::dvec3(NAN);
    std::memcpy(m.data(), bytes.data(), sizeof m);
    const glm::dvec4 row(point, 1.0);
    glm::dvec4 result(0.0);
    for (int i = 0; i < 16; ++i) result[i % 4] += row[i / 4] * double(m[std::size_t(i)]);
    return glm::dvec3(result) / result.w;
}

/// Centre of what shines in a picture, 0 to 1 from the upper left corner.
glm::dvec2 centreOfLight(const Image& image) {
    glm::dvec2 sum(0.0);
    double weight = 0.0;
    for (int y = 0; y < image.size.y; ++y) {
        for (int x = 0; x < image.size.x; ++x) {
            sum += double(image.at(x, y).g) * (glm::dvec2(x, y) + 0.5);
            weight += double(image.at(x, y).g);
        }
    }
    return sum / weight / glm::dvec2(image.size);
}

TEST(ExrAttributes, MatricesTakeAPointToWhereItIsSeen) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kPane), file = folder.file("pane.exr");
    const RunResult result = runEikonal({"render", scene, "-o", file, "--samples", "64"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string exr = readText(file);
    const glm::dvec3 pane(0.5, 0.3125, -0.1875), position(0.4, 0.7, 4.0), lookAt(0.1, 0.0, 0.2);
    const glm::dvec2 seen = centreOfLight(readImage(file));
    ASSERT_TRUE(std::isfinite(seen.x));
    const glm::dvec3 ndc = transformed(pane, attribute(exr, "worldToNDC", "m44f"));
    EXPECT_NEAR(ndc.x, seen.x, 0.1 / 64.0);  // a tenth of a pixel, of which the pane has two
    EXPECT_NEAR(ndc.y, seen.y, 0.1 / 48.0);

    const std::string toCamera = attribute(exr, "worldToCamera", "m44f");
    const double distance = glm::length(lookAt - position);
    EXPECT_LT(glm::length(transformed(position, toCamera)), 1e-5);
    EXPECT_LT(glm::length(transformed(lookAt, toCamera) - glm::dvec3(0.0, 0.0, distance)), 1e-5);
    const glm::dvec3 above = transformed(lookAt + glm::dvec3(0.0, 0.1, 0.0), toCamera);
    EXPECT_GT(above.y, 0.0);
    EXPECT_NEAR(above.x, 0.0, 1e-6);
    const glm::dvec3 right = glm::cross(lookAt - position, glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_GT(transformed(lookAt + right, toCamera).x, 0.0);
}

TEST(ExrAttributes, SayWhatMadeThePicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kPane), file = folder.file("pane.exr");
    ASSERT_EQ(runEikonal({"render", scene, "-o", file, "--samples", "4"}).exitCode, 0);
    const std::string exr = readText(file);
    EXPECT_EQ(attribute(exr, "creator", "string").rfind("Eikonal ", 0), 0u);
    EXPECT_EQ(attribute(exr, "software", "string"), attribute(exr, "creator", "string"));
    EXPECT_NE(attribute(exr, "scene", "string").find("emission = 10"), std::string::npos);
    EXPECT_GT(number(attribute(exr, "seconds", "float")), 0.0f);
    EXPECT_EQ(number(attribute(exr, "samples", "float")), 4.0f);
    EXPECT_GT(number(attribute(exr, "noise", "float")), 0.0f);
}

} // namespace
} // namespace eikonal::test

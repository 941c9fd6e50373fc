// Objects with lattices of their own, by commands.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

/// A plate across the view that a turn about y tilts, n = 1.5 and absorbing, on a lattice far finer than the domain's.
const std::string kPlate = R"([domain]
resolution = 12
[[object]]
name = "plate"
shape = "box"
size = [0.8, 0.8, 0.3]
ior = 1.5
absorption = [1, 2, 3]
resolution = 128
[render]
size = [6, 4]
[camera]
position = [0, 0, 5]
fov = 10
)";

struct Traced {
    double x = 0.0, dx = 0.0, dz = 0.0, depth = 0.0;
};

Traced traced(const std::string& angle) {
    const TemporaryFolder folder;
    const RunResult result = runEikonal(
        {"trace", folder.write("scene.toml", kPlate), "--rays", folder.write("in.csv", "x,y,z,dx,dy,dz\n0.01,0.02,3,0,0,-1\n"),
         "-o", folder.file("out.csv"), "--set", "object.plate.rotate=[0, " + angle + ", 0]", "--quiet"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    std::string text = readText(folder.file("out.csv"));
    text.erase(0, text.find('\n') + 1);
    std::vector<double> row;
    for (std::size_t at = 0; at < text.size() && row.size() < 11; at = text.find(',', at) + 1) {
        row.push_back(std::stod(text.substr(at)));
    }
    return row.size() < 11 ? Traced{} : Traced{row[0], row[3], row[5], row[8]};
}

/// How far a ray is shifted sideways by the plate at an angle to its normal: n sin(theta) is the same in all of its layers, also
/// in those of its boundaries, which are smoothed over 1.5 of its voxels.
double shiftThroughPlate(double angle) {
    const double width = 1.5 * 0.8 / 114.0, step = 1e-5;
    double along = 0.0;
    for (double z = -0.5; z < 0.5; z += step) {
        const auto coverage = [&](double distance) { return 0.5 * std::erfc(distance / (std::sqrt(2.0) * width)); };
        const double n = 1.0 + 0.5 * coverage(std::abs(z) - 0.15);
        along += step * (std::tan(angle) - std::tan(std::asin(std::sin(angle) / n)));
    }
    return along * std::cos(angle);
}

} // namespace

TEST(InsetCommands, TraceShiftsRaysThroughATiltedPlateAsSnellSays) {
    const Traced straight = traced("0"), tilted = traced("40");
    // At each face samples of a ramp of two voxels of 0.007 are three quarters of one apart: off by a tenth of one at most.
    EXPECT_NEAR(straight.depth, 0.3, 1.5e-3);
    EXPECT_NEAR(straight.x, 0.01, 1e-5);
    const double angle = 40.0 * std::acos(-1.0) / 180.0, inside = std::asin(std::sin(angle) / 1.5);
    const double shift = shiftThroughPlate(angle);
    EXPECT_NEAR(tilted.dx, 0.0, 1e-3);  // faces are parallel, and n sin(theta) the same before and behind
    EXPECT_NEAR(tilted.dz, -1.0, 1e-3);
    EXPECT_NEAR(std::abs(tilted.x - 0.01), shift, 1e-3);  // 1e-3 of direction over the unit behind
    EXPECT_NEAR(tilted.depth, 0.3 / std::cos(inside), 3e-3);
}

TEST(InsetCommands, InfoListsThem) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kPlate);
    const RunResult plain = runEikonal({"info", scene, "--set", "object.0.translate=[0.8, 0, 0]"});
    EXPECT_EQ(plain.exitCode, 0);
    EXPECT_NE(plain.out.find("object 'plate': 128 x 128 x 57 voxels of 0.00701754; what reaches beyond the domain is not seen"),
              std::string::npos)
        << plain.out;
    const auto summary = nlohmann::json::parse(runEikonal({"info", scene, "--json"}).out);
    const auto& inset = summary.at("insets").at(0);
    EXPECT_EQ(inset.at("voxels"), 128 * 128 * 57);
    EXPECT_FALSE(inset.at("cut"));
    EXPECT_GE(summary.at("memory_bytes").get<double>(), inset.at("bytes").get<double>());
    for (const auto& effect : summary.at("effects"))
        if (effect.at("name") == "absorption") {
            EXPECT_TRUE(effect.at("on")) << "what an inset absorbs counts";
        }
}

TEST(InsetCommands, StatisticsNameTheirTextures) {
    const TemporaryFolder folder;
    const RunResult result = runEikonal({"render", folder.write("scene.toml", kPlate), "-o", folder.file("plate.exr"), "--stats",
                                         folder.file("stats.json"), "--quiet"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto textures = nlohmann::json::parse(readText(folder.file("stats.json"))).at("textures");
    const auto bytesOf = [&](const char* name) {
        const auto row = std::find_if(textures.begin(), textures.end(), [&](const auto& t) { return t.at("name") == name; });
        return row == textures.end() ? 0 : row->at("bytes").template get<int>();
    };
    EXPECT_EQ(bytesOf("inset_values"), 128 * 128 * 57 * 16) << "coverage with its gradient: glass is the same everywhere";
    EXPECT_EQ(bytesOf("inset_extents"), 128 * 128 * 57 * 4);
    EXPECT_EQ(bytesOf("optics"), 16) << "nothing is on the domain's own lattice";
}

TEST(InsetCommands, RefuseLaterObjectsOverThem) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kPlate + "[[object]]\nname = \"ball\"\nradius = 0.2\n");
    const RunResult result = runEikonal({"render", scene, "-o", folder.file("image.png")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("object 'ball': expected objects without a resolution before those with one"), std::string::npos)
        << result.err;
    EXPECT_EQ(runEikonal({"bake", scene, "-o", folder.file("bake.vdb"), "--quiet"}).exitCode, 0) << "a bake has them on one lattice";
}

} // namespace eikonal::test

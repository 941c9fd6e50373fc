// Dispersion through the commands: wavelengths of `trace`, grids of bands in a bake, scenes in which nothing disperses.

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/image_io.h"
#include "common/spectrum.h"
#include "common/vdb_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

using nlohmann::json;

/// What a command writes to the file `out` of the folder.
std::string outputOf(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    const RunResult result = runEikonal(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return readText(folder.file("out"));
}

/// The directions' y of the rows that `trace` writes.
std::vector<double> tracedY(const std::string& csv) {
    std::vector<double> rows;
    std::istringstream lines(csv);
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string field;
        for (int column = 0; column < 5; ++column) {
            std::getline(fields, field, ',');
        }
        rows.push_back(std::stod(field));
    }
    return rows;
}

const std::vector<std::string> kDispersing{"--set", "object.0.cauchy_b=0.03", "--set", "accuracy.bands=5"};

} // namespace

TEST(DispersionCommands, TraceReadsWavelengths) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const std::string rays = folder.write("rays.csv", "x,y,z,dx,dy,dz,wavelength_nm\n"
                                                      "-2,0.2,0,1,0,0,450\n-2,0.2,0,1,0,0,587.6\n-2,0.2,0,1,0,0,650\n");
    const auto dispersed = tracedY(outputOf(folder, {"trace", scene, "--rays", rays, "-o", folder.file("out"), "--set",
                                                   "object.0.cauchy_b=0.03"}));
    ASSERT_EQ(dispersed.size(), 3u);
    EXPECT_LT(dispersed[0], dispersed[1]);
    EXPECT_LT(dispersed[1], dispersed[2]);
    const auto plain = tracedY(outputOf(folder, {"trace", scene, "--rays", rays, "-o", folder.file("out")}));
    EXPECT_EQ(plain[0], plain[1]);
    EXPECT_EQ(plain[1], dispersed[1]) << "0.5876 µm is where the index is given";
}

TEST(DispersionCommands, ABakeHoldsItsBandsAndLightsThePicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    std::vector<std::string> bake{"bake", scene, "-o", folder.file("bake.vdb"), "--stats", folder.file("out")};
    bake.insert(bake.end(), kDispersing.begin(), kDispersing.end());
    const json energy = json::parse(outputOf(folder, bake)).at("energy");
    const VdbFile file = readVdb(folder.file("bake.vdb"));
    for (const SpectralBand& band : spectralBands(5)) {
        const VdbGrid* grid = file.find("irradiance_" + std::to_string(std::lround(band.wavelengthNm())) + "nm");
        ASSERT_NE(grid, nullptr) << band.wavelengthNm();
        EXPECT_EQ(grid->typeName, "float");
    }
    ASSERT_NE(file.find("irradiance"), nullptr);
    EXPECT_EQ(file.find("irradiance")->typeName, "vec3s");
    for (const char* row : {"wavelengths_nm", "entered", "balance", "deposited_scattered"}) {
        EXPECT_EQ(energy.at(row).size(), 5u) << row;
    }

    std::vector<std::string> render{"render", scene, "-o", folder.file("stored.exr")};
    render.insert(render.end(), kDispersing.begin(), kDispersing.end());
    std::vector<std::string> fromFile = render;
    fromFile.insert(fromFile.end(), {"--bake", folder.file("bake.vdb")});
    ASSERT_EQ(runEikonal(fromFile).exitCode, 0);
    render[3] = folder.file("now.exr");
    ASSERT_EQ(runEikonal(render).exitCode, 0);
    EXPECT_EQ(readImage(folder.file("stored.exr")).pixels, readImage(folder.file("now.exr")).pixels);
}

TEST(DispersionCommands, WithoutCauchysBNothingChanges) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const auto bakeAndPicture = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> bake{"bake", scene, "-o", folder.file(name + ".vdb")};
        std::vector<std::string> render{"render", scene, "-o", folder.file(name + ".png")};
        bake.insert(bake.end(), more.begin(), more.end());
        render.insert(render.end(), more.begin(), more.end());
        EXPECT_EQ(runEikonal(bake).exitCode, 0);
        EXPECT_EQ(runEikonal(render).exitCode, 0);
        return std::pair(readVdb(folder.file(name + ".vdb")), readText(folder.file(name + ".png")));
    };
    const auto [bake, picture] = bakeAndPicture("plain", {});
    const auto [zeroBake, zeroPicture] =
        bakeAndPicture("zero", {"--set", "object.0.cauchy_b=0", "--set", "accuracy.bands=8"});
    const auto [leftOutBake, leftOutPicture] =
        bakeAndPicture("left_out", {"--set", "object.0.cauchy_b=0.03", "--set",
                                    "render.effects=[\"refraction\", \"scattering\", \"reflection\", \"environment\"]"});
    EXPECT_EQ(zeroPicture, picture);
    EXPECT_EQ(leftOutPicture, picture);
    for (const VdbFile* other : {&zeroBake, &leftOutBake}) {
        EXPECT_EQ(other->grids.size(), bake.grids.size());
        EXPECT_EQ(other->find("irradiance")->vector().values, bake.find("irradiance")->vector().values);
        EXPECT_EQ(other->find("light_direction")->vector().values, bake.find("light_direction")->vector().values);
    }
}

} // namespace eikonal::test

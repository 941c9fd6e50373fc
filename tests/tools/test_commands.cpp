// The commands end to end: what they write, that it repeats, and that failures leave nothing behind.

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/image_io.h"
#include "common/vdb_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

using nlohmann::json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Bakes kSmallScene in `folder` and gives the path of the bake.
std::string smallBake(const TemporaryFolder& folder, const std::string& name = "bake.vdb") {
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result = runEikonal({"bake", scene, "-o", folder.file(name)});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return folder.file(name);
}

std::vector<std::vector<std::string>> csvRows(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) {
            rows.back().push_back(field);
        }
    }
    return rows;
}

/// Stages of --stats that are all there is.
void expectSumOfStages(const json& seconds, const std::vector<std::string>& stages) {
    double sum = 0.0;
    for (const std::string& stage : stages) {
        ASSERT_TRUE(seconds.contains(stage)) << stage << " in " << seconds;
        EXPECT_GE(seconds[stage], -1e-9) << stage;  // differences of clocks' readings
        sum += seconds[stage].get<double>();
    }
    EXPECT_EQ(seconds.size(), stages.size() + 1) << seconds;
    EXPECT_GT(seconds["total"], 0.0);
    EXPECT_NEAR(seconds["total"], sum, 1e-9 * sum);  // rounding
}

const std::string kTraceHeader = "x,y,z,dx,dy,dz,optical_length,length,depth_r,depth_g,depth_b,steps,status";

} // namespace

TEST(BakeCommand, WritesGridsAndMetadata) {
    const TemporaryFolder folder;
    const VdbFile file = readVdb(smallBake(folder));
    const VdbGrid* irradiance = file.find("irradiance");
    const VdbGrid* direction = file.find("light_direction");
    ASSERT_NE(irradiance, nullptr);
    ASSERT_NE(direction, nullptr);
    EXPECT_EQ(irradiance->typeName, "vec3s");
    EXPECT_EQ(irradiance->size(), glm::ivec3(16));
    EXPECT_EQ(direction->size(), glm::ivec3(16));
    for (const char* key : {"creator", "version", "scene", "scene_hash", "energy", "seconds", "renderer"}) {
        EXPECT_TRUE(file.metadata.contains(key)) << key;
    }
}

TEST(BakeCommand, TwoRunsGiveTheSameBytes) {
    const TemporaryFolder folder;
    const VdbFile first = readVdb(smallBake(folder, "a.vdb"));
    const VdbFile second = readVdb(smallBake(folder, "b.vdb"));
    EXPECT_TRUE(first.find("irradiance")->vector().values == second.find("irradiance")->vector().values);
    EXPECT_TRUE(first.find("light_direction")->vector().values == second.find("light_direction")->vector().values);
}

TEST(BakeCommand, WritesLobesThatRenderReads) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1, scene);
        arguments.insert(arguments.end(), {"--set", "medium.anisotropy=0.7", "--set", "accuracy.directional=lobes"});
        const RunResult result = runEikonal(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.err;
    };
    run({"bake", "-o", folder.file("bake.vdb")});
    const VdbFile file = readVdb(folder.file("bake.vdb"));
    const auto grid = [&](const std::string& name) -> const DenseGrid<glm::vec3>& { return file.find(name)->vector(); };
    std::size_t several = 0;
    for (std::size_t i = 0; i < grid("irradiance").values.size(); ++i) {
        const glm::vec3 sum = grid("lobe1_irradiance").values[i] + grid("lobe2_irradiance").values[i] +
                              grid("lobe3_irradiance").values[i];
        EXPECT_LE(glm::length(sum - grid("irradiance").values[i]), 1e-6f * glm::length(sum));  // rounded to single precision
        several += grid("lobe2_irradiance").values[i] != glm::vec3(0.0f) ? 1 : 0;
    }
    EXPECT_GT(several, 0u);
    run({"render", "--bake", folder.file("bake.vdb"), "-o", folder.file("of_file.png")});
    run({"render", "-o", folder.file("at_once.png")});
    EXPECT_EQ(readText(folder.file("of_file.png")), readText(folder.file("at_once.png")));
}

TEST(BakeCommand, StatisticsHoldTheDocumentedKeys) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result = runEikonal({"bake", scene, "-o", folder.file("b.vdb"), "--stats", folder.file("b.json")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json statistics = json::parse(readText(folder.file("b.json")));
    for (const char* key : {"seconds", "patches", "energy", "effects", "device", "memory_bytes"}) {
        EXPECT_TRUE(statistics.contains(key)) << key;
    }
    for (const char* key : {"peak", "steps", "field_evaluations", "splits", "folds"}) {
        EXPECT_TRUE(statistics["patches"].contains(key)) << key;
    }
    for (const char* key : {"emitted", "entered", "absorbed", "scattered", "exited", "reflected", "culled", "balance",
                            "deposited_absorbed", "deposited_scattered"}) {
        ASSERT_TRUE(statistics["energy"].contains(key)) << key;
        EXPECT_EQ(statistics["energy"][key].size(), 3u) << key;
    }
    EXPECT_GT(statistics["error_estimate"]["total"], 0.0);
    EXPECT_LT(statistics["error_estimate"]["total"], 1.0);
    for (const char* key : {"propagation", "averaging", "field_evaluations", "seconds"}) {
        EXPECT_TRUE(statistics["error_estimate"].contains(key)) << key;
    }
    expectSumOfStages(statistics["seconds"], {"compose", "upload", "propagate", "lobes", "read", "other", "estimate", "write"});
    for (const double balance : statistics["energy"]["balance"]) {
        EXPECT_LE(std::abs(balance), 0.002);
    }
}

TEST(BakeCommand, SecondsAreAllThatSomebodyWaitsFor) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(runEikonal({"bake", scene, "-o", folder.file("b_##.vdb"), "--frames", "3", "--stats", folder.file("b.json"), "--set",
                          "domain.resolution=32"}).exitCode, 0);
    const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const json statistics = json::parse(readText(folder.file("b.json")));
    double told = 0.0;
    for (const json& frame : statistics.at("frames")) {
        told += frame["seconds"]["total"].get<double>();
    }
    EXPECT_LE(told, waited);
    EXPECT_GT(told, 0.7 * waited);  // the rest is the program's start and end
}

TEST(BakeCommand, LightGoesByLeapfrogAndSaysSo) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1, scene);
        const RunResult result = runEikonal(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return result.err;
    };
    const std::string plain = run({"bake", "-o", folder.file("a.vdb")});
    const std::string euler = run({"bake", "-o", folder.file("b.vdb"), "--set", "accuracy.integrator=euler"});
    const std::string warning = "--set accuracy.integrator=euler: accuracy.integrator: 'euler' is for viewing rays; light goes by leapfrog";
    EXPECT_FALSE(contains(plain, "integrator")) << plain;
    EXPECT_TRUE(contains(euler, warning)) << euler;
    EXPECT_EQ(readVdb(folder.file("a.vdb")).find("irradiance")->vector().values,
              readVdb(folder.file("b.vdb")).find("irradiance")->vector().values);
    EXPECT_TRUE(contains(run({"render", "-o", folder.file("a.png"), "--set", "accuracy.integrator=euler"}), warning));
    run({"render", "-o", folder.file("b.png"), "--set", "accuracy.integrator=euler", "--bake", folder.file("a.vdb")});
    EXPECT_EQ(readText(folder.file("a.png")), readText(folder.file("b.png"))) << "one bake does for both";
}

TEST(BakeCommand, EstimatesNoErrorWhereThereIsNoneToEstimateOrNobodyAsks) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    std::vector<std::string> arguments{"bake", scene, "-o", folder.file("b.vdb"), "--stats", folder.file("b.json"),
                                       "--set", "accuracy.deposit=peak"};
    ASSERT_EQ(runEikonal(arguments).exitCode, 0);
    EXPECT_TRUE(json::parse(readText(folder.file("b.json"))).at("error_estimate").is_null());
    arguments.push_back("--no-estimate");
    ASSERT_EQ(runEikonal(arguments).exitCode, 0);
    EXPECT_FALSE(json::parse(readText(folder.file("b.json"))).contains("error_estimate"));
}

TEST(BakeCommand, AnInterruptedRunLeavesNoFile) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const auto interrupt = [](pid_t child) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        ::kill(child, SIGINT);
    };
    const RunResult result =
        runEikonal({"bake", scene, "--resolution", "256", "-o", folder.file("out.vdb"), "--stats", folder.file("s.json")},
                   {.whileRunning = interrupt});
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_EQ(result.signal, 0);
    EXPECT_TRUE(contains(result.err, "interrupted")) << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.toml"});
}

TEST(BakeCommand, AFailedRunKeepsTheOldFile) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", "[[object]]\nior = 0\n");
    const std::string old = folder.write("out.vdb", "precious");
    EXPECT_EQ(runEikonal({"bake", scene, "-o", old}).exitCode, 3);
    EXPECT_EQ(readText(old), "precious");
}

TEST(Commands, AFullDiskIsReported) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const std::string rays = folder.write("rays.csv", "x,y,z,dx,dy,dz\n-2,0,0,1,0,0\n");
    const std::vector<std::pair<std::string, std::vector<std::string>>> runs{
        {"full.vdb", {"bake", scene, "-o"}},
        {"full.exr", {"render", scene, "-o"}},
        {"full.png", {"render", scene, "-o"}},
        {"full.csv", {"trace", scene, "--rays", rays, "-o"}},
        {"full.obj", {"figure", "-o"}},
    };
    for (const auto& [name, command] : runs) {
        std::filesystem::create_symlink("/dev/full", folder.path() / name);
        std::vector<std::string> arguments = command;
        arguments.push_back(folder.file(name));
        const RunResult result = runEikonal(arguments);
        EXPECT_EQ(result.exitCode, 1) << name << ": " << result.err;
        EXPECT_TRUE(contains(result.err, "error: ")) << name << ": " << result.err;
    }
    EXPECT_EQ(runEikonal({"info", scene}, {.standardOutput = "/dev/full"}).exitCode, 1);
}

TEST(RenderCommand, WritesEveryFormat) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    for (const std::string name : {"a.exr", "a.png", "a.jpg"}) {
        const RunResult result = runEikonal({"render", scene, "-o", folder.file(name), "--size", "40x30"});
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(readImage(folder.file(name)).size, glm::ivec2(40, 30)) << name;
    }
}

TEST(RenderCommand, AStoredBakeGivesTheSamePicture) {
    const TemporaryFolder folder;
    const std::string bake = smallBake(folder);
    const std::string scene = folder.file("scene.toml");
    ASSERT_EQ(runEikonal({"render", scene, "-o", folder.file("a.exr")}).exitCode, 0);
    ASSERT_EQ(runEikonal({"render", scene, "--bake", bake, "-o", folder.file("b.exr")}).exitCode, 0);
    EXPECT_EQ(readImage(folder.file("a.exr")).pixels, readImage(folder.file("b.exr")).pixels);
}

TEST(RenderCommand, AnotherScenesBakeExitsWith3AndNamesTheKeys) {
    const TemporaryFolder folder;
    const std::string bake = smallBake(folder);
    const std::vector<std::string> arguments{"render", folder.file("scene.toml"), "--bake", bake, "-o",
                                             folder.file("out.png"), "--set", "medium.scattering=0.7"};
    const RunResult refused = runEikonal(arguments);
    EXPECT_EQ(refused.exitCode, 3) << refused.err;
    EXPECT_TRUE(contains(refused.err, "medium.scattering")) << refused.err;
    EXPECT_FALSE(contains(refused.err, "domain.resolution")) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.png"));

    std::vector<std::string> forced = arguments;
    forced.push_back("--force");
    EXPECT_EQ(runEikonal(forced).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out.png"));
}

TEST(RenderCommand, WhatABakeDoesNotDependOnMayDiffer) {
    const TemporaryFolder folder;
    const std::string bake = smallBake(folder);
    const RunResult result = runEikonal({"render", folder.file("scene.toml"), "--bake", bake, "-o", folder.file("out.png"),
                                         "--set", "camera.fov=20", "--set", "render.exposure=1", "--size", "16x16"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
}

TEST(RenderCommand, StatisticsHoldTheDocumentedKeys) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult result =
        runEikonal({"render", scene, "-o", folder.file("a.png"), "--stats", folder.file("a.json")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json statistics = json::parse(readText(folder.file("a.json")));
    expectSumOfStages(statistics["seconds"], {"compose", "light", "setup", "image", "estimate", "write"});
    expectSumOfStages(statistics["bake"]["seconds"], {"upload", "propagate", "lobes", "read", "other"});
    for (const char* key : {"seconds", "rays", "samples", "noise", "steps", "field_evaluations", "effects", "device",
                            "memory_bytes", "textures", "error_estimate"}) {
        EXPECT_TRUE(statistics.contains(key)) << key;
    }
    EXPECT_EQ(statistics["rays"], 32 * 24);
    EXPECT_GT(statistics["error_estimate"]["total"], 0.0);  // of one sample a pixel
    runEikonal({"render", scene, "-o", folder.file("a.png"), "--stats", folder.file("b.json"), "--no-estimate"});
    EXPECT_FALSE(json::parse(readText(folder.file("b.json"))).contains("error_estimate"));
}

TEST(TraceCommand, WritesOneRowPerRayInOrder) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", "[domain]\nresolution = 16\n");
    const std::string rays =
        folder.write("rays.csv", "x,y,z,dx,dy,dz\n-3,0.25,0,2,0,0\n-3,5,0,1,0,0\n0,0,0,0,0,-1\n");
    const RunResult result = runEikonal({"trace", scene, "--rays", rays, "-o", folder.file("out.csv")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = csvRows(readText(folder.file("out.csv")));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(readText(folder.file("out.csv")).substr(0, kTraceHeader.size() + 1), kTraceHeader + "\n");

    EXPECT_EQ(rows[1].at(12), "exited");
    EXPECT_NEAR(std::stod(rows[1][0]), 1.0, 1e-6);  // on the face where it leaves
    EXPECT_NEAR(std::stod(rows[1][1]), 0.25, 1e-6);
    EXPECT_NEAR(std::stod(rows[1][3]), 1.0, 1e-6);  // unit direction
    EXPECT_NEAR(std::stod(rows[1][7]), 2.0, 1e-5);  // from where it enters

    EXPECT_EQ(rows[2].at(12), "missed");
    EXPECT_EQ(std::stod(rows[2][1]), 5.0);  // the input row, repeated
    EXPECT_EQ(std::stod(rows[2][7]), 0.0);

    EXPECT_EQ(rows[3].at(12), "exited");
    EXPECT_NEAR(std::stod(rows[3][2]), -1.0, 1e-6);
    EXPECT_NEAR(std::stod(rows[3][7]), 1.0, 1e-5);  // from its start inside
}

TEST(TraceCommand, PointsBeginAndEndWhereTheRayDoes) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const std::string rays = folder.write("rays.csv", "x,y,z,dx,dy,dz\n-3,0.1,0,1,0,0\n-3,0.2,0,1,0,0\n");
    ASSERT_EQ(runEikonal({"trace", scene, "--rays", rays, "--points", "-o", folder.file("points.csv")}).exitCode, 0);
    const auto rows = csvRows(readText(folder.file("points.csv")));
    ASSERT_GT(rows.size(), 10u);
    EXPECT_EQ(rows[0].at(0), "ray");
    EXPECT_EQ(rows[1].at(0), "0");
    EXPECT_NEAR(std::stod(rows[1].at(1)), -1.0, 1e-6);
    EXPECT_EQ(rows.back().at(0), "1");
    EXPECT_NEAR(std::stod(rows.back().at(1)), 1.0, 1e-6);
}

TEST(TraceCommand, PointsSayHowTheirRayEnds) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene + "[[object]]\nopaque = true\nradius = 0.2\ntranslate = [0.7, 0, 0]\n");
    const std::string rays = folder.write("rays.csv", "x,y,z,dx,dy,dz\n-3,0,0,1,0,0\n-3,0.9,0,1,0,0\n-3,5,0,1,0,0\n");
    ASSERT_EQ(runEikonal({"trace", scene, "--rays", rays, "--points", "-o", folder.file("points.csv")}).exitCode, 0);
    const std::vector<std::string> ends{"absorbed", "exited", "missed"};
    const auto rows = csvRows(readText(folder.file("points.csv")));
    ASSERT_GT(rows.size(), 10u);
    for (std::size_t row = 1; row < rows.size(); ++row) EXPECT_EQ(rows[row].at(13), ends.at(std::stoul(rows[row].at(0)))) << row;
}

TEST(TraceCommand, ARayThereAndBackIsTheSameRay) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const std::string there = folder.write("there.csv", "x,y,z,dx,dy,dz\n-1,0.2,0.1,1,0,0\n");
    ASSERT_EQ(runEikonal({"trace", scene, "--rays", there, "-o", folder.file("end.csv")}).exitCode, 0);
    const auto end = csvRows(readText(folder.file("end.csv"))).at(1);
    std::string back = "x,y,z,dx,dy,dz\n" + end[0] + "," + end[1] + "," + end[2];
    for (int axis = 3; axis < 6; ++axis) {
        back.append(",").append(std::to_string(-std::stod(end[std::size_t(axis)])));
    }
    const std::string backFile = folder.write("back.csv", back + "\n");
    ASSERT_EQ(runEikonal({"trace", scene, "--rays", backFile, "-o", folder.file("start.csv")}).exitCode, 0);
    const auto start = csvRows(readText(folder.file("start.csv"))).at(1);
    EXPECT_NEAR(std::stod(start[0]), -1.0, 1e-4);
    EXPECT_NEAR(std::stod(start[1]), 0.2, 0.01);
    EXPECT_NEAR(std::stod(start[2]), 0.1, 0.01);
}

TEST(InfoCommand, ShowsAVolume) {
    const TemporaryFolder folder;
    const std::string bake = smallBake(folder);
    const RunResult text = runEikonal({"info", bake});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    EXPECT_TRUE(contains(text.out, "irradiance"));
    EXPECT_TRUE(contains(text.out, "16 x 16 x 16")) << text.out;
    const RunResult data = runEikonal({"info", bake, "--json"});
    EXPECT_EQ(data.exitCode, 0);
    EXPECT_EQ(json::parse(data.out)["grids"].size(), 2u);
}

/// The line of the table of effects that begins with a name.
std::string rowOf(const std::string& table, const std::string& effect) {
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("  " + effect + " ", 0) == 0) return line;
    }
    return {};
}

TEST(InfoCommand, ShowsEffectsAndCostOfAScene) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult text = runEikonal({"info", scene});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    for (const char* part : {" on ", " MiB ", " ior ", "the index varies from 1 to 1."}) {
        EXPECT_TRUE(contains(rowOf(text.out, "refraction"), part)) << part << " in\n" << text.out;
    }
    EXPECT_TRUE(contains(rowOf(text.out, "emission"), " off ")) << text.out;
    EXPECT_FALSE(contains(rowOf(text.out, "emission"), " MiB ")) << text.out;
    const RunResult data = runEikonal({"info", scene, "--json"});
    EXPECT_EQ(data.exitCode, 0);
    EXPECT_TRUE(json::parse(data.out).contains("effects"));
}

TEST(Effects, AreTheOnesThatAreAllowed) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene), image = folder.file("i.png");
    const RunResult few = runEikonal({"render", scene, "-o", image, "--effects", "refraction,emission", "--explain", "--quiet", "--stats",
                                      folder.file("i.json"), "--no-estimate"});
    ASSERT_EQ(few.exitCode, 0) << few.err;
    EXPECT_TRUE(contains(rowOf(few.out, "refraction"), " on ")) << few.out;
    EXPECT_TRUE(contains(rowOf(few.out, "scattering"), "left out by render.effects, though something scatters")) << few.out;
    EXPECT_TRUE(contains(rowOf(few.out, "emission"), "nothing emits")) << "what the scene does not call for stays off";
    for (const auto& effect : json::parse(readText(folder.file("i.json")))["effects"]) {
        EXPECT_EQ(effect["on"].get<bool>(), effect["name"] == "refraction") << effect;
    }
    const std::string picture = readText(image);
    const RunResult byKey = runEikonal({"render", scene, "-o", image, "--set", "render.effects=[\"refraction\", \"emission\"]", "--quiet"});
    ASSERT_EQ(byKey.exitCode, 0) << byKey.err;
    EXPECT_EQ(byKey.out, "") << "the table is for those who ask";
    EXPECT_EQ(readText(image), picture);
    const RunResult dark = runEikonal({"bake", scene, "-o", folder.file("b.vdb"), "--effects", "auto", "--explain", "--quiet"});
    ASSERT_EQ(dark.exitCode, 0) << dark.err;
    EXPECT_TRUE(contains(rowOf(dark.out, "scattering"), " on ")) << dark.out;
}

TEST(Effects, ThatAreUnknownAreRefused) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.toml", kSmallScene);
    const RunResult unknown = runEikonal({"info", scene, "--effects", "refraction,magic"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_TRUE(contains(unknown.err, "expected 'refraction', ") && contains(unknown.err, "found string 'magic'")) << unknown.err;
    const RunResult noName = runEikonal({"info", scene, "--effects", "'x"});
    EXPECT_EQ(noName.exitCode, 2);
    EXPECT_TRUE(contains(noName.err, "expected names such as refraction,absorption, found ''x'")) << noName.err;
}

} // namespace eikonal::test

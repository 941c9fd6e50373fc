// Bad input: each case ends with one message, the documented exit code, and no file left behind.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "common/image_io.h"
#include "common/vdb_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

/// Something that is wrong: `prepare` writes the input files and gives the command line.
struct BadCase {
    std::string name;
    int exitCode;
    std::string message;  ///< part of what stderr must say
    std::function<std::vector<std::string>(const TemporaryFolder&)> prepare;
    std::vector<std::string> environment = {};
};

void PrintTo(const BadCase& bad, std::ostream* stream) { *stream << bad.name; }

std::vector<std::string> bakeOf(const TemporaryFolder& folder, const std::string& scene) {
    return {"bake", folder.write("scene.toml", scene), "-o", folder.file("out.vdb"), "--stats", folder.file("out.json")};
}

std::vector<std::string> renderOf(const TemporaryFolder& folder, const std::string& scene) {
    return {"render", folder.write("scene.toml", scene), "-o", folder.file("out.exr"), "--stats", folder.file("out.json")};
}

/// A VDB with grids `ior` (float) and `colour` (vec3s).
std::string writeSmallVdb(const TemporaryFolder& folder) {
    const Lattice lattice{.min = glm::dvec3(-1.0), .voxel = 0.25, .size = glm::ivec3(8)};
    const DenseGrid<float> ior(lattice.size, 1.3f);
    const DenseGrid<glm::vec3> colour(lattice.size, glm::vec3(0.5f));
    writeVdb(folder.path() / "small.vdb", lattice, {{"ior", &ior, glm::vec3(1.0f)}, {"colour", &colour}}, {});
    return folder.file("small.vdb");
}

std::string writeTruncatedVdb(const TemporaryFolder& folder) {
    const std::string whole = readText(writeSmallVdb(folder));
    return folder.write("small.vdb", whole.substr(0, whole.size() / 2));
}

void writeEnvironmentWithNan(const TemporaryFolder& folder) {
    std::vector<float> values(8 * 4, 1.0f);
    values[9] = std::numeric_limits<float>::quiet_NaN();
    writeExr(folder.path() / "sky.exr", {8, 4}, {{"R", &values}, {"G", &values}, {"B", &values}}, {});
}

const std::vector<float> kSky{1.0f, 1.0f};
const std::string kVolumeObject = "[[object]]\nvolume = \"small.vdb\"\n";

class BadInput : public testing::TestWithParam<BadCase> {};

} // namespace

TEST_P(BadInput, EndsWithAMessageAndNoFile) {
    const BadCase& bad = GetParam();
    const TemporaryFolder folder;
    const std::vector<std::string> arguments = bad.prepare(folder);
    const std::vector<std::string> before = folder.names();
    const RunResult result = runEikonal(arguments, {.environment = bad.environment});
    EXPECT_EQ(result.signal, 0);
    EXPECT_EQ(result.exitCode, bad.exitCode) << result.err;
    EXPECT_NE(result.err.find("error: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), before) << "files were left behind";
}

static const std::vector<BadCase> kVolumeCases{
    {"EmptyVdb", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         f.write("small.vdb", "");
         return bakeOf(f, kVolumeObject);
     }},
    {"TruncatedVdb", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         writeTruncatedVdb(f);
         return bakeOf(f, kVolumeObject);
     }},
    {"NoVdb", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         f.write("small.vdb", "this is a letter and no volume, whatever its name says");
         return bakeOf(f, kVolumeObject);
     }},
    {"MissingVdb", 3, "small.vdb", [](const TemporaryFolder& f) { return renderOf(f, kVolumeObject); }},
    {"EmptyVdbAsScene", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"bake", f.write("small.vdb", ""), "-o", f.file("out.vdb")};
     }},
    {"TruncatedVdbToInfo", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"info", writeTruncatedVdb(f)};
     }},
    {"TruncatedBake", 3, "small.vdb",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"render", f.write("scene.toml", kSmallScene), "--bake", writeTruncatedVdb(f),
                                         "-o", f.file("out.png")};
     }},
    {"BakeWithNan", 3, "finite values in grid 'irradiance'",
     [](const TemporaryFolder& f) {
         const Lattice lattice{.min = glm::dvec3(-1.0), .voxel = 0.25, .size = glm::ivec3(8)};
         DenseGrid<glm::vec3> light(lattice.size, glm::vec3(1.0f));
         light.at(1, 2, 3).y = std::numeric_limits<float>::quiet_NaN();
         writeVdb(f.path() / "nan.vdb", lattice, {{"irradiance", &light}, {"light_direction", &light}}, {});
         return std::vector<std::string>{"render", f.write("scene.toml", kSmallScene), "--bake", f.file("nan.vdb"), "--force", "-o",
                                         f.file("out.png")};
     }},
    {"VdbThatIsNoBake", 3, "irradiance",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"render", f.write("scene.toml", kSmallScene), "--bake", writeSmallVdb(f),
                                         "-o", f.file("out.png")};
     }},
    {"GridOfTheWrongType", 3, "colour",
     [](const TemporaryFolder& f) {
         writeSmallVdb(f);
         return bakeOf(f, kVolumeObject + "[object.grids]\nior = \"colour\"\n");
     }},
    {"GridThatIsNotThere", 3, "flavour",
     [](const TemporaryFolder& f) {
         writeSmallVdb(f);
         return bakeOf(f, kVolumeObject + "[object.grids]\nior = \"flavour\"\n");
     }},
};

static const std::vector<BadCase> kSceneCases{
    {"TwoSkies", 3, "expected one of 'image', 'color' and 'gradient', found 'image' and 'color'",
     [](const TemporaryFolder& f) {
         writeExr(f.path() / "sky.exr", {2, 1}, {{"R", &kSky}, {"G", &kSky}, {"B", &kSky}}, {});
         return renderOf(f, kSmallScene + "[environment]\nimage = \"sky.exr\"\ncolor = [1, 1, 1]\n");
     }},
    {"LobesOfADepositWithOneDirection", 3, ".toml:18:15: accuracy.directional: expected 'auto' or 'mean'",
     [](const TemporaryFolder& f) {
         return bakeOf(f, kSmallScene + "[accuracy]\ndirectional = \"lobes\"\ndeposit = \"peak\"\n");
     }},
    {"ReflectionsWithoutTubes", 3, "--set accuracy.deposit=splat: accuracy.reflections: expected 0",
     [](const TemporaryFolder& f) {
         auto arguments = bakeOf(f, kSmallScene + "[accuracy]\nreflections = 1\n");
         arguments.insert(arguments.end(), {"--set", "accuracy.deposit=splat"});
         return arguments;
     }},
    {"EikonalWithoutTubes", 3, "--set accuracy.deposit=peak: accuracy.deposit: expected 'auto' or 'cells' for an eikonal, found 'peak'",
     [](const TemporaryFolder& f) {
         auto arguments = bakeOf(f, kSmallScene + "[accuracy]\ndeposit = \"auto\"\n");
         arguments.insert(arguments.end(), {"--eikonal", "--set", "accuracy.deposit=peak"});
         return arguments;
     }},
    {"MissingScene", 3, "nowhere.toml",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"bake", f.file("nowhere.toml"), "-o", f.file("out.vdb")};
     }},
    {"MeshInPlaceOfAScene", 3, "eikonal voxelize",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"render", f.write("ball.obj", "v 0 0 0\n"), "-o", f.file("out.png")};
     }},
    {"UnknownKey", 3, "scene.toml:2:1",
     [](const TemporaryFolder& f) { return bakeOf(f, "[domain]\nresolutoin = 32\n"); }},
    {"UnknownKeyHasASuggestion", 3, "resolution",
     [](const TemporaryFolder& f) { return bakeOf(f, "[domain]\nresolutoin = 32\n"); }},
    {"WrongType", 3, "scene.toml:2:", [](const TemporaryFolder& f) { return bakeOf(f, "[domain]\nresolution = \"big\"\n"); }},
    {"NoToml", 3, "scene.toml:1:", [](const TemporaryFolder& f) { return bakeOf(f, "= = =\n"); }},
    {"IndexOfZero", 3, "scene.toml:3:", [](const TemporaryFolder& f) { return bakeOf(f, "[[object]]\nshape = \"sphere\"\nior = 0\n"); }},
    {"IndexExpressionBelowZero", 3, "scene.toml:3:",
     [](const TemporaryFolder& f) { return bakeOf(f, "[[object]]\nshape = \"field\"\nior = \"x - 3\"\n"); }},
    {"IndexThatIsNan", 3, "scene.toml:3:",
     [](const TemporaryFolder& f) { return bakeOf(f, "[[object]]\nshape = \"sphere\"\nior = nan\n"); }},
    {"ExpressionThatIsNan", 3, "scene.toml:3:",
     [](const TemporaryFolder& f) { return bakeOf(f, "[[object]]\nshape = \"field\"\nior = \"sqrt(-1 - r)\"\n"); }},
    {"OverrideThatIsNoKey", 3, "domain.resolutoin",
     [](const TemporaryFolder& f) {
         auto arguments = bakeOf(f, kSmallScene);
         arguments.insert(arguments.end(), {"--set", "domain.resolutoin=32"});
         return arguments;
     }},
    {"MissingEnvironment", 3, "sky.exr",
     [](const TemporaryFolder& f) { return renderOf(f, "[environment]\nimage = \"sky.exr\"\n"); }},
    {"EnvironmentWithNan", 3, "sky.exr",
     [](const TemporaryFolder& f) {
         writeEnvironmentWithNan(f);
         return renderOf(f, "[environment]\nimage = \"sky.exr\"\n");
     }},
    {"DomainBeyondTheDevice", 3, "",
     [](const TemporaryFolder& f) {
         return bakeOf(f, "[domain]\nmin = [0, 0, 0]\nmax = [1000, 0.1, 0.1]\nresolution = 40000\n"
                          "[medium]\nscattering = 0.1\nabsorption = \"0.1*x\"\n[[light]]\ntype = \"directional\"\n");
     }},
    {"MeshWithoutVolume", 3, "flat.obj",
     [](const TemporaryFolder& f) {
         f.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
         return bakeOf(f, "[[object]]\nmesh = \"flat.obj\"\n");
     }},
    {"MeshWithoutVolumeToVoxelize", 3, "flat.obj",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"voxelize", f.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "-o",
                                         f.file("out.vdb")};
     }},
    {"LobesWithDispersion", 3, "accuracy.directional",
     [](const TemporaryFolder& f) {
         auto arguments = bakeOf(f, kSmallScene);
         arguments.insert(arguments.end(), {"--set", "object.0.cauchy_b=0.01", "--set", "accuracy.directional=lobes"});
         return arguments;
     }},
    {"EikonalWithDispersion", 3, "cauchy_b",
     [](const TemporaryFolder& f) {
         auto arguments = bakeOf(f, kSmallScene);
         arguments.insert(arguments.end(), {"--set", "object.0.cauchy_b=0.01", "--eikonal"});
         return arguments;
     }},
    {"RaysThatAreNoRays", 3, "rays.csv:2:",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"trace", f.write("scene.toml", kSmallScene), "--rays",
                                         f.write("rays.csv", "x,y,z,dx,dy,dz\n1,2,3\n"), "-o", f.file("out.csv")};
     }},
};

static const std::vector<BadCase> kSystemCases{
    {"NoOpenGl", 4, "4.5", [](const TemporaryFolder& f) { return bakeOf(f, kSmallScene); },
     {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"}},
    {"NoOpenGlToRender", 4, "4.5", [](const TemporaryFolder& f) { return renderOf(f, kSmallScene); },
     {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"}},
    {"UnwritableFolder", 1, "nowhere",
     [](const TemporaryFolder& f) {
         return std::vector<std::string>{"bake", f.write("scene.toml", kSmallScene), "-o", f.file("nowhere/out.vdb")};
     }},
};

static std::string nameOf(const testing::TestParamInfo<BadCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Volume, BadInput, testing::ValuesIn(kVolumeCases), nameOf);
INSTANTIATE_TEST_SUITE_P(Scene, BadInput, testing::ValuesIn(kSceneCases), nameOf);
INSTANTIATE_TEST_SUITE_P(System, BadInput, testing::ValuesIn(kSystemCases), nameOf);

} // namespace eikonal::test

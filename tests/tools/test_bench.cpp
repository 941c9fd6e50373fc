// `eikonal bench`: tables that say what they must, whatever the machine's speed.
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/run_eikonal.h"

namespace eikonal {
namespace {

using Table = std::vector<std::vector<std::string>>;

/// Rows and fields of a CSV; lines that begin with # are comments.
Table tableOf(const std::string& csv) {
    Table rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
    return rows;
}

/// A small ball of tinted glass on a floor under a lamp.
const char* const kScene = "[domain]\nresolution = 24\n"
                           "[[object]]\nradius = 0.4\nabsorption = [0.5, 1, 2]\n"
                           "[[object]]\nshape = \"plane\"\nopaque = true\ntranslate = [0, -0.6, 0]\n"
                           "[[light]]\ndirection = [0.2, -1, 0]\n"
                           "[render]\nsize = [16, 12]\n";

TEST(Bench, SpeedGivesRatesAndTheirShares) {
    const test::TemporaryFolder folder;
    const auto run = test::runEikonal({"bench", "speed", folder.write("s.toml", kScene), "--repeats", "1"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Table table = tableOf(run.out);
    ASSERT_EQ(table.size(), 5u) << run.out;
    EXPECT_EQ(table[0], (std::vector<std::string>{"kernel", "fetches", "seconds", "million_per_second", "share"}));
    EXPECT_EQ(table[1][0], "dependent_fetches");
    EXPECT_EQ(std::stod(table[1][4]), 1.0);
    EXPECT_GT(std::stod(table[2][1]), std::stod(table[3][1])) << "flights fetch less than steps through everything";
    EXPECT_GT(std::stod(table[3][1]), 0.0);
    EXPECT_EQ(table[4][0], "image");
    // The same rays, but for where in their pixels they begin.
    EXPECT_NEAR(std::stod(table[4][1]), std::stod(table[3][1]), 0.05 * std::stod(table[3][1]));
}

TEST(Bench, SpeedWritesATableAndBars) {
    const test::TemporaryFolder folder;
    const auto run = test::runEikonal({"bench", "speed", folder.write("s.toml", kScene), "--repeats", "1", "-o", folder.file("speed.csv"),
                                       "--svg", folder.file("speed.svg")});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.out, "");
    const Table table = tableOf(test::readText(folder.file("speed.csv")));
    ASSERT_EQ(table.size(), 5u);
    const std::string svg = test::readText(folder.file("speed.svg"));
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
    for (const char* bar : {"fetches alone", "every step", "with flights", "whole image"}) EXPECT_NE(svg.find(bar), std::string::npos) << bar;
}

TEST(Bench, SpeedNeedsAnIndexThatVaries) {
    const test::TemporaryFolder folder;
    const auto run = test::runEikonal({"bench", "speed", folder.write("s.toml", "[domain]\nresolution = 8\n")});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.err.find("expected an index that varies"), std::string::npos) << run.err;
}

TEST(Bench, EffectsAddUpToTheWholeImage) {
    const test::TemporaryFolder folder;
    const std::string scene = folder.write("s.toml", kScene);
    const auto run = test::runEikonal({"bench", "effects", scene, "-o", folder.file("ladder.csv"), "--svg",
                                       folder.file("ladder.svg"), "--repeats", "1", "--quiet"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const Table table = tableOf(test::readText(folder.file("ladder.csv")));
    std::vector<std::string> added;
    for (std::size_t i = 1; i < table.size(); ++i) added.push_back(table[i][0]);
    EXPECT_EQ(added, (std::vector<std::string>{"refraction", "environment", "absorption", "reflection", "opaque"}));
    const auto image = test::runEikonal({"render", scene, "-o", folder.file("i.png"), "--stats", folder.file("i.json"),
                                         "--quiet"});
    ASSERT_EQ(image.exitCode, 0) << image.err;
    const auto whole = nlohmann::json::parse(test::readText(folder.file("i.json")));
    EXPECT_EQ(table.back()[3], std::to_string(whole.at("steps").get<std::uint64_t>()));
    EXPECT_EQ(table.back()[4], std::to_string(whole.at("field_evaluations").get<std::uint64_t>()));
    for (std::size_t i = 2; i < table.size(); ++i)
        EXPECT_GE(std::stoull(table[i][8]), std::stoull(table[i - 1][8])) << "no effect takes a texture away";
    EXPECT_EQ(table[0].back(), "march_instructions");
    for (std::size_t i = 1; i < table.size(); ++i) EXPECT_EQ(table[i].size(), table[1].size()) << "the driver tells of all kernels or of none";
    const std::string svg = test::readText(folder.file("ladder.svg"));
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
    EXPECT_NE(svg.find("+ reflection"), std::string::npos);
}

} // namespace
} // namespace eikonal

// Rays from CSV: what is accepted, and where errors point.

#include <sstream>

#include <gtest/gtest.h>

#include "common/error.h"
#include "tools/ray_csv.h"

namespace eikonal::test {

namespace {

std::vector<RayRow> parse(const std::string& text) {
    std::istringstream stream(text);
    return readRayCsv(stream, "rays.csv");
}

std::string errorOf(const std::string& text) {
    try {
        parse(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(RayCsv, ReadsRowsInOrder) {
    const auto rows = parse("x,y,z,dx,dy,dz\n1,2,3,0,0,1\n-1e-3, .5 ,0,1,1,0\r\n");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].origin, glm::dvec3(1, 2, 3));
    EXPECT_EQ(rows[0].direction, glm::dvec3(0, 0, 1));
    EXPECT_FALSE(rows[0].wavelengthNm);
    EXPECT_EQ(rows[1].origin, glm::dvec3(-1e-3, 0.5, 0));
}

TEST(RayCsv, ReadsColumnsByName) {
    const auto rows = parse("wavelength_nm,dx,dy,dz,x,y,z\n550,0,0,1,7,8,9");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].origin, glm::dvec3(7, 8, 9));
    EXPECT_EQ(rows[0].wavelengthNm, 550.0);
}

TEST(RayCsv, DirectionsMayBeOfAnyLength) {
    EXPECT_EQ(parse("x,y,z,dx,dy,dz\n0,0,0,0,1e-200,0\n")[0].direction, glm::dvec3(0, 1e-200, 0));
}

TEST(RayCsv, AHeaderAloneIsNoRays) { EXPECT_TRUE(parse("x,y,z,dx,dy,dz\n").empty()); }

TEST(RayCsv, NamesThePlaceOfAnError) {
    const std::string header = "x,y,z,dx,dy,dz\n";
    EXPECT_NE(errorOf("").find("the file is empty"), std::string::npos);
    EXPECT_NE(errorOf("x,y,z,dx,dy\n").find("column 'dz' is missing"), std::string::npos);
    EXPECT_NE(errorOf("x,y,z,dx,dy,dz,nm\n").find("rays.csv:1:16: "), std::string::npos);
    EXPECT_NE(errorOf("x,x,y,z,dx,dy,dz\n").find("stands twice"), std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,0,0,0,1\n0,0,0,0,0\n").find("rays.csv:3:1: expected 6 fields"), std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,zero,0,0,1\n").find("rays.csv:2:5: expected a finite number, found 'zero'"),
              std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,nan,0,0,1\n").find("expected a finite number"), std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,1e999,0,0,1\n").find("expected a finite number"), std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,,0,0,1\n").find("found ''"), std::string::npos);
    EXPECT_NE(errorOf(header + "0,0,0,0,0,0\n").find("rays.csv:2:7: expected a direction"), std::string::npos);
    EXPECT_NE(errorOf("x,y,z,dx,dy,dz,wavelength_nm\n0,0,0,0,0,1,0\n").find("above 0 nm"), std::string::npos);
}

} // namespace eikonal::test

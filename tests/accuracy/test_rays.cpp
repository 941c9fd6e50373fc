// Rays through `eikonal trace`, leapfrog at one voxel on 128³ over the box ±1.125: RMS error of the exit direction against
// closed forms. The bounds are the program's promises; docs/performance.md has what was measured.
#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "common/physics.h"
#include "common/reference/reference_field.h"
#include "common/vdb_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal {
namespace {

using glm::dvec3;

constexpr double kHalf = 1.125;
constexpr int kResolution = 128;

struct Row {
    dvec3 x, direction;
    std::string status;
};

std::string fieldScene(const std::string& ior) {
    return "[domain]\nmin = [-1.125, -1.125, -1.125]\nmax = [1.125, 1.125, 1.125]\nresolution = 128\n"
           "[[object]]\nshape = \"field\"\nsize = [2.25, 2.25, 2.25]\nior = \"" + ior + "\"\n";
}

std::string csvOf(const std::vector<f64::Ray>& rays) {
    std::ostringstream csv;
    csv.precision(17);
    csv << "x,y,z,dx,dy,dz\n";
    for (const f64::Ray& ray : rays) {
        csv << ray.x.x << ',' << ray.x.y << ',' << ray.x.z << ',' << ray.w.x << ',' << ray.w.y << ',' << ray.w.z << '\n';
    }
    return csv.str();
}

std::vector<std::vector<std::string>> cellsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) {
            rows.back().push_back(cell);
        }
    }
    return rows;
}

std::vector<Row> traced(const test::TemporaryFolder& folder, const std::string& scene, const std::vector<f64::Ray>& rays) {
    const std::string input = folder.write("rays.csv", csvOf(rays));
    const auto run = test::runEikonal({"trace", scene, "--rays", input, "-o", folder.file("out.csv"), "--set",
                                       "accuracy.step=1", "--quiet"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::vector<Row> rows;
    for (const auto& cells : cellsOf(test::readText(folder.file("out.csv")))) {
        const auto number = [&](std::size_t i) { return std::stod(cells.at(i)); };
        rows.push_back({{number(0), number(1), number(2)}, {number(3), number(4), number(5)}, cells.at(12)});
    }
    EXPECT_EQ(rows.size(), rays.size());
    return rows;
}

double rmsOf(const std::vector<Row>& rows, const std::vector<dvec3>& truth) {
    double squares = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].status, "exited");
        squares += glm::dot(rows[i].direction - truth[i], rows[i].direction - truth[i]);
    }
    return std::sqrt(squares / double(rows.size()));
}

/// Rays along +x in many meridional planes, impact parameters evenly up to `largest`.
std::vector<f64::Ray> beam(double largest) {
    std::vector<f64::Ray> rays;
    const int count = 400;
    for (int i = 0; i < count; ++i) {
        const double radius = largest * (i + 0.5) / count;
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        rays.push_back({{-kHalf, radius * std::cos(angle), radius * std::sin(angle)}, {1.0, 0.0, 0.0}});
    }
    return rays;
}

TEST(RayAccuracy, LuneburgLens) {
    const test::TemporaryFolder folder;
    const std::string scene = folder.write("luneburg.toml", fieldScene("r < 1 ? sqrt(2 - r*r) : 1"));
    const auto rays = beam(0.95);
    std::vector<dvec3> truth;
    for (const f64::Ray& ray : rays) {
        // a quarter of the period from the entry to the far pole: the wave vector there is minus the entry point
        const double b2 = ray.x.y * ray.x.y + ray.x.z * ray.x.z;
        truth.push_back({std::sqrt(1.0 - b2), -ray.x.y, -ray.x.z});
    }
    EXPECT_LE(rmsOf(traced(folder, scene, rays), truth), 1.2e-3);
}

TEST(RayAccuracy, GradedRod) {
    const test::TemporaryFolder folder;
    const double n0 = 1.8, radius = 0.7;
    const double g = std::sqrt(1.0 - 1.0 / (n0 * n0)) / radius;
    std::ostringstream ior;
    ior.precision(17);
    ior << "x*x + y*y < 0.49 ? 1.8*sqrt(1 - " << g * g << "*(x*x + y*y)) : 1";
    const std::string scene = folder.write("rod.toml", fieldScene(ior.str()));
    std::vector<f64::Ray> rays;
    std::vector<dvec3> truth;
    for (const f64::Ray& ray : beam(0.3)) {
        const dvec3 start(ray.x.y, ray.x.z, -kHalf);
        rays.push_back({start, {0.0, 0.0, 1.0}});
        const double r2 = start.x * start.x + start.y * start.y;
        const double wz = n0 * std::sqrt(1.0 - g * g * r2);  // conserved
        const double phase = n0 * g * 2.0 * kHalf / wz;
        const dvec3 w(-start.x * n0 * g * std::sin(phase), -start.y * n0 * g * std::sin(phase), wz);
        truth.push_back(glm::normalize(w));
    }
    EXPECT_LE(rmsOf(traced(folder, scene, rays), truth), 2e-4);
}

TEST(RayAccuracy, FishEye) {
    // Rays in r < 0.98 never leave: their directions are compared along one pass of 150 steps, where n²(x) (x × w) and the
    // circle through the start say what they are.
    const test::TemporaryFolder folder;
    const double a2 = 0.49;
    const std::string scene = folder.write("fish_eye.toml", fieldScene("3/(1 + r*r/0.49)"));
    std::vector<f64::Ray> rays;
    for (int i = 0; i < 24; ++i) {
        // tangential starts between r = 0.55 and 0.9: the other end of the orbit is at 0.49/r
        const double r = 0.55 + 0.35 * i / 23.0, angle = 0.7 * i, tilt = 0.3 * i;
        const dvec3 x(r * std::cos(angle), r * std::sin(angle), 0.0);
        const dvec3 tangent(-std::sin(angle) * std::cos(tilt), std::cos(angle) * std::cos(tilt), std::sin(tilt));
        rays.push_back({x, tangent});
    }
    const std::string input = folder.write("rays.csv", csvOf(rays));
    const auto run = test::runEikonal({"trace", scene, "--rays", input, "--points", "-o", folder.file("out.csv"),
                                       "--set", "accuracy.step=1", "--quiet"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    double squares = 0.0;
    int count = 0;
    std::vector<int> steps(rays.size(), 0);
    for (const auto& cells : cellsOf(test::readText(folder.file("out.csv")))) {
        const std::size_t index = std::stoul(cells.at(0));
        ASSERT_LT(index, rays.size());
        if (++steps[index] > 150) {
            continue;
        }
        const auto number = [&](std::size_t i) { return std::stod(cells.at(i)); };
        const dvec3 x(number(1), number(2), number(3)), direction(number(4), number(5), number(6));
        // the orbit's circle: start and image are the ends of a diameter, since the start is tangential
        const dvec3 start = rays[index].x;
        const dvec3 image = -start * (a2 / glm::dot(start, start));
        const dvec3 radius = x - 0.5 * (start + image);
        const dvec3 axis = glm::normalize(glm::cross(start - image, rays[index].w));
        const dvec3 tangent = glm::normalize(glm::cross(axis, radius));
        squares += glm::dot(direction - tangent, direction - tangent);
        ++count;
    }
    ASSERT_GT(count, 24 * 140);
    EXPECT_LE(std::sqrt(squares / count), 7e-4);
}

constexpr double kSphereRadius = 0.8, kSphereWidth = 0.04;

/// Exit directions through the smoothed sphere: Bouguer's integral, as leapfrog with steps of 1/50 of the width, whose own
/// error is below 1e-6.
std::vector<dvec3> throughSmoothedSphere(const std::vector<f64::Ray>& rays) {
    const reference::SmoothedSphere sphere(kSphereRadius, 1.5, kSphereWidth);
    const double ds = kSphereWidth / 50.0;
    std::vector<dvec3> directions;
    for (f64::Ray ray : rays) {
        while (ray.x.x < kHalf && std::abs(ray.x.y) < kHalf && std::abs(ray.x.z) < kHalf) {
            ray = f64::driftByLength(ray, 0.5 * ds);
            ray = f64::driftByLength(f64::kickByLength(ray, sphere.optics(ray.x).gradN, ds), 0.5 * ds);
        }
        directions.push_back(glm::normalize(ray.w));
    }
    return directions;
}

TEST(RayAccuracy, SmoothedSphereAsShape) {
    const test::TemporaryFolder folder;
    const std::string scene = folder.write("sphere.toml",
        "[domain]\nmin = [-1.125, -1.125, -1.125]\nmax = [1.125, 1.125, 1.125]\nresolution = 128\n"
        "[[object]]\nshape = \"sphere\"\nradius = 0.8\nior = 1.5\nsmooth = 2.2755555555555556\n");
    const auto rays = beam(0.95 * kSphereRadius);
    EXPECT_LE(rmsOf(traced(folder, scene, rays), throughSmoothedSphere(rays)), 1e-3);
}

TEST(RayAccuracy, SmoothedSphereAsGrid) {
    const test::TemporaryFolder folder;
    const Lattice lattice{dvec3(-kHalf), 2.0 * kHalf / kResolution, glm::ivec3(kResolution)};
    const reference::SmoothedSphere sphere(kSphereRadius, 1.5, kSphereWidth);
    DenseGrid<float> ior(lattice.size, 1.0f);
    for (int k = 0; k < kResolution; ++k) {
        for (int j = 0; j < kResolution; ++j) {
            for (int i = 0; i < kResolution; ++i) {
                ior.at(i, j, k) = float(sphere.optics(lattice.worldFromIndex({i, j, k})).n);
            }
        }
    }
    writeVdb(folder.file("sphere.vdb"), lattice, {{"ior", &ior, glm::vec3(1.0f)}}, {});
    const auto rays = beam(0.95 * kSphereRadius);
    EXPECT_LE(rmsOf(traced(folder, folder.file("sphere.vdb"), rays), throughSmoothedSphere(rays)), 1e-3);
}

} // namespace
} // namespace eikonal

// Meshes: read, repaired, measured, and turned into distances.

#include "common/mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "common/mesh_generate.h"
#include "tests/files/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::test {
namespace {

constexpr double kBall = 4.0 / 3.0 * glm::pi<double>();

Mesh scaled(Mesh mesh, double factor, bool inwards = false) {
    for (glm::dvec3& v : mesh.vertices)
        v *= factor;
    if (inwards)
        for (glm::ivec3& t : mesh.triangles)
            std::swap(t.y, t.z);
    return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
    const glm::ivec3 shift(int(a.vertices.size()));
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const glm::ivec3& t : b.triangles)
        a.triangles.push_back(t + shift);
    return a;
}

/// Drops the triangles that `drop` says, by their centroid.
template <class Drop>
Mesh without(Mesh mesh, Drop&& drop) {
    std::erase_if(mesh.triangles, [&](const glm::ivec3& t) {
        return drop((mesh.vertices[std::size_t(t.x)] + mesh.vertices[std::size_t(t.y)] + mesh.vertices[std::size_t(t.z)]) / 3.0);
    });
    return mesh;
}

Lattice cube(int resolution, double half) { return {glm::dvec3(-half), 2.0 * half / resolution, glm::ivec3(resolution)}; }

TEST(Mesh, IcosphereVolumeConverges) {
    double previous = 1.0;
    for (int level = 1; level <= 4; ++level) {
        const double error = kBall - meshVolume(generateIcosphere(level));
        EXPECT_GT(error, 0.0) << "an inscribed polyhedron is smaller";
        EXPECT_LT(error / previous, level == 1 ? 1.0 : 0.3) << "second order in the edge: a quarter per level";
        previous = error;
    }
}

TEST(Mesh, GeneratedKnotIsAClosedSolid) {
    const Mesh knot = generateKnot();
    const MeshReport report = inspectMesh(knot);
    EXPECT_EQ(report.openEdges, 0u);
    EXPECT_EQ(report.nonManifoldEdges, 0u);
    EXPECT_EQ(std::ptrdiff_t(report.vertices) - std::ptrdiff_t(report.triangles) / 2, 0) << "Euler's number of a torus";
    EXPECT_GT(meshVolume(knot), 0.0);
    // Overlapping strands would count twice in the mesh's volume and once in the voxels'.
    const double volume = voxelizedVolume(signedDistance(knot, cube(96, 1.1), glm::dmat4(1.0), 2.0), 2.2 / 96);
    EXPECT_NEAR(volume / meshVolume(knot), 1.0, 0.005);
}

TEST(Mesh, ObjRoundTripWeldsAndKeepsTheSolid) {
    const TemporaryFolder folder;
    const Mesh sphere = generateIcosphere(2);
    writeObj(folder / "a.obj", sphere);
    const Mesh read = loadMesh(folder / "a.obj");
    EXPECT_EQ(read.vertices.size(), sphere.vertices.size());
    EXPECT_EQ(read.triangles.size(), sphere.triangles.size());
    EXPECT_EQ(inspectMesh(read).openEdges, 0u);
    EXPECT_NEAR(meshVolume(read), meshVolume(sphere), 1e-6);  // coordinates are single precision in the importer
}

TEST(Mesh, StlIsWelded) {
    const TemporaryFolder folder;
    const Mesh sphere = generateIcosphere(1);
    std::string text = "solid s\n";
    for (const glm::ivec3& t : sphere.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& v = sphere.vertices[std::size_t(t[i])];
            text += "vertex " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    writeText(folder / "a.stl", text + "endsolid s\n");
    const Mesh read = loadMesh(folder / "a.stl");
    EXPECT_EQ(read.vertices.size(), sphere.vertices.size());
    EXPECT_EQ(inspectMesh(read).openEdges, 0u);
}

TEST(Mesh, BadFilesAreBadInput) {
    const TemporaryFolder folder;
    expectError(ExitCode::kBadInput, "no such file", [&] { loadMesh(folder / "none.obj"); });
    writeText(folder / "garbage.obj", "\x01\x02 this is no mesh\n");
    expectError(ExitCode::kBadInput, "garbage.obj", [&] { loadMesh(folder / "garbage.obj"); });
    writeText(folder / "empty.ply", "");
    expectError(ExitCode::kBadInput, "empty.ply", [&] { loadMesh(folder / "empty.ply"); });
    writeText(folder / "nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectError(ExitCode::kBadInput, "finite", [&] { loadMesh(folder / "nan.obj"); });
    writeText(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    expectError(ExitCode::kBadInput, "points.obj", [&] { loadMesh(folder / "points.obj"); });
    writeText(folder / "sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    expectError(ExitCode::kBadInput, "encloses a volume", [&] { loadSolidMesh(folder / "sheet.obj"); });
}

TEST(Mesh, HolesAreClosedAndTold) {
    // Two caps cut off where |z| > 0.7: the flat fans leave a ball between two planes.
    Mesh open = without(generateIcosphere(4), [](const glm::dvec3& c) { return std::abs(c.z) > 0.7; });
    const MeshReport report = closeHoles(open);
    EXPECT_GT(report.openEdges, 0u);
    EXPECT_EQ(report.boundaryLoops, 2u);
    EXPECT_EQ(report.loopsCapped, 2u);
    EXPECT_TRUE(report.closed());
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].find("2 holes"), std::string::npos) << report.messages[0];
    const double h = 0.7, expected = 2.0 * glm::pi<double>() * (h - h * h * h / 3.0);
    EXPECT_NEAR(meshVolume(open), expected, 0.03 * expected);  // the rims follow triangles of edge 0.07, not the planes
}

TEST(Mesh, HolesThatTouchAreClosedOneByOne) {
    const Mesh whole = generateIcosphere(0);
    // Triangles 0 and 7 of the icosahedron share a single vertex.
    Mesh open = whole;
    open.triangles.erase(open.triangles.begin() + 7);
    open.triangles.erase(open.triangles.begin());
    const MeshReport report = closeHoles(open);
    EXPECT_EQ(report.loopsCapped, 2u);
    EXPECT_TRUE(report.closed());
    EXPECT_NEAR(meshVolume(open), meshVolume(whole), 1e-12);  // the fans lie in the missing triangles' planes
}

TEST(Mesh, TurnsWhatFacesTheWrongWay) {
    Mesh mixed = generateIcosphere(2);
    for (std::size_t i = 0; i < mixed.triangles.size(); i += 5)
        std::swap(mixed.triangles[i].y, mixed.triangles[i].z);
    const MeshReport report = closeHoles(mixed);
    EXPECT_TRUE(report.closed());
    EXPECT_FALSE(report.messages.empty());
    EXPECT_NEAR(meshVolume(mixed), meshVolume(generateIcosphere(2)), 1e-12);
    Mesh inside = scaled(generateIcosphere(2), 1.0, true);
    closeHoles(inside);
    EXPECT_GT(meshVolume(inside), 0.0);
}

TEST(SignedDistance, OfASphereIsRadiusMinusOne) {
    const Lattice lattice = cube(40, 1.5);
    const DenseGrid<float> distance = signedDistance(generateIcosphere(5), lattice, glm::dmat4(1.0), 6.0);
    double worst = 0.0;
    for (int k = 0; k < 40; ++k)
        for (int j = 0; j < 40; ++j)
            for (int i = 0; i < 40; ++i) {
                const double exact = glm::length(lattice.worldFromIndex({i, j, k})) - 1.0;
                const double band = 6.0 * lattice.voxel;
                worst = std::max(worst, std::abs(std::clamp(exact, -band, band) - double(distance.at(i, j, k))));
            }
    EXPECT_LT(worst, 4e-4);  // so far the polyhedron lies within the sphere: 1 - cos of half an edge's angle
}

TEST(SignedDistance, InnerCavitiesAreOutside) {
    const Mesh shell = joined(generateIcosphere(3), scaled(generateIcosphere(3), 0.5, true));
    const Lattice lattice = cube(48, 1.2);
    const DenseGrid<float> distance = signedDistance(shell, lattice, glm::dmat4(1.0), 3.0);
    const float band = float(3.0 * lattice.voxel);
    EXPECT_FLOAT_EQ(distance.at(24, 24, 24), band) << "the cavity's middle";
    EXPECT_FLOAT_EQ(distance.at(24 + 15, 24, 24), -band) << "the wall's middle";
    EXPECT_FLOAT_EQ(distance.at(0, 0, 0), band);
    // The boundary voxels' share of their volume is second order in the voxel: 1e-3 here.
    EXPECT_NEAR(voxelizedVolume(distance, lattice.voxel) / meshVolume(shell), 1.0, 3e-3);
}

TEST(SignedDistance, LinesThroughVerticesAndEdgesAgree) {
    // An octahedron with its corners on voxel centres: every axis through the middle meets edges and vertices exactly.
    const Mesh octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    const Lattice lattice{glm::dvec3(-1.25 - 0.125 / 2), 0.125, glm::ivec3(21)};
    const DenseGrid<float> distance = signedDistance(octahedron, lattice, glm::dmat4(1.0), 2.0);
    for (int k = 0; k < 21; ++k)
        for (int j = 0; j < 21; ++j)
            for (int i = 0; i < 21; ++i) {
                const glm::dvec3 p = glm::abs(lattice.worldFromIndex({i, j, k}));
                const double side = p.x + p.y + p.z - 1.0;
                if (std::abs(side) > 1e-9) {
                    EXPECT_EQ(distance.at(i, j, k) < 0.0f, side < 0.0) << i << " " << j << " " << k;
                }
            }
}

TEST(SignedDistance, FollowsTheTransform) {
    const glm::dmat4 worldFromMesh =
        glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, 0.0, 0.0)), 0.7, glm::dvec3(0, 0, 1)),
                   glm::dvec3(0.4, 0.8, -0.4));
    const Lattice lattice = cube(64, 1.2);
    const DenseGrid<float> distance = signedDistance(generateIcosphere(4), lattice, worldFromMesh, 2.0);
    const double expected = meshVolume(generateIcosphere(4)) * 0.4 * 0.8 * 0.4;
    EXPECT_NEAR(voxelizedVolume(distance, lattice.voxel) / expected, 1.0, 5e-3);  // second order in the voxel
}

TEST(SignedDistance, OnlyPartOfTheMeshMayLieOnTheLattice) {
    const Lattice corner{glm::dvec3(0.0), 0.05, glm::ivec3(30)};
    const DenseGrid<float> distance = signedDistance(generateIcosphere(4), corner, glm::dmat4(1.0), 2.0);
    EXPECT_NEAR(voxelizedVolume(distance, 0.05) / (kBall / 8.0), 1.0, 0.01);
    const Lattice away{glm::dvec3(5.0), 0.05, glm::ivec3(8)};
    for (const float d : signedDistance(generateIcosphere(2), away, glm::dmat4(1.0), 2.0).values)
        EXPECT_GT(d, 0.0f);
}

TEST(SignedDistance, ASheetEnclosesNothing) {
    const Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    expectError(ExitCode::kBadInput, "encloses a volume",
                [&] { signedDistance(sheet, cube(16, 2.0), glm::dmat4(1.0), 2.0); });
}

TEST(WallThickness, OfAShellIsItsWall) {
    const Mesh shell = joined(generateIcosphere(4), scaled(generateIcosphere(4), 0.95, true));
    const WallThickness walls = wallThickness(shell);
    // Measured along lines up to 55 degrees off the normal, where a curved wall of facets seems a little thinner.
    EXPECT_NEAR(walls.thinnest, 0.05, 0.004);
    EXPECT_NEAR(walls.median, 0.05, 0.005);
    EXPECT_NEAR(walls.resolutionForTwoVoxels(2.0), 80, 6);
}

} // namespace
} // namespace eikonal::test

// Ray tubes: closed forms inside gradients, and a launch mesh without gaps.
#include <numeric>
#include <vector>

#include "lightsim/tubes/launch_mesh.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

/// Irradiance between the middles of voxels.
double irradianceAt(const BakedLight& light, const glm::dvec3& x) {
    const glm::dvec3 place = (x - light.lattice.min) / light.lattice.voxel - 0.5;
    const glm::ivec3 base(glm::floor(place));
    const glm::dvec3 t = place - glm::dvec3(base);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - t, t, glm::dvec3(step));
        sum += light.irradiance.at(base + step).x * w.x * w.y * w.z;
    }
    return sum;
}

TEST(Tubes, MatchTheLuneburgLensInside) {
    const Lattice lattice = test::cube(128, 1.125);
    const Fields fields = test::indexFields(lattice, [](const glm::dvec3& x) {
        const double r2 = glm::dot(x, x);
        return r2 < 1.0 ? std::sqrt(2.0 - r2) : 1.0;
    });
    const BakeResult result = test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), fields);
    // ray-tube Jacobian of x(τ) = x0 cos τ + w0 sin τ; x along the beam, y across. 1.5 %: the promise at default accuracy,
    // most of it the lattice's, which knows the kink of n at r = 1 to a voxel
    EXPECT_NEAR(irradianceAt(result.light, {0.0, 0.0, 0.0}), 2.0, 0.015 * 2.0);
    EXPECT_NEAR(irradianceAt(result.light, {0.0, 0.3, 0.0}), 1.717481, 0.015 * 1.717481);
    EXPECT_NEAR(irradianceAt(result.light, {0.5, 0.2, 0.0}), 4.586985, 0.015 * 4.586985);
}

TEST(Tubes, NeedAThirdOfTheFieldEvaluationsOfPatches) {
    const Fields fields = test::absorbingSphereInSmoke(32);
    Scene scene = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});
    const BakeResult tubes = test::bake(scene, fields);
    scene.accuracy.deposit = Deposit::kSplat;
    const BakeResult patches = test::bake(scene, fields);
    // the promise is a third; counted, not timed
    EXPECT_LT(3 * tubes.statistics.patches.fieldEvaluations, patches.statistics.patches.fieldEvaluations);
}

bake::LaunchFrame frameOfCells(std::uint32_t across) {
    bake::LaunchFrame frame{};
    frame.cellsU = frame.cellsV = across;
    return frame;
}

std::vector<std::uint32_t> numbersFrom(std::size_t first, std::size_t end) {
    std::vector<std::uint32_t> numbers(end - first);
    std::iota(numbers.begin(), numbers.end(), std::uint32_t(first));
    return numbers;
}

enum class Measured { kAll, kOnlyNew };

/// Refines edges about one point of launch coordinates, those within half their length of it, as a caustic would have it. What
/// is measured in a round: everything, or all edges first and then what the round before has made.
void refineAbout(bake::LaunchMesh& mesh, const glm::uvec2& place, int times, Measured measured) {
    const bool onlyNew = measured == Measured::kOnlyNew;
    std::vector<std::uint32_t> edges = numbersFrom(0, mesh.edges.size()), nodes = numbersFrom(0, onlyNew ? 0 : mesh.nodes.size());
    for (int i = 0; i < times; ++i) {
        for (const std::uint32_t index : edges) {
            bake::MeshEdge& edge = mesh.edges[index];
            const glm::uvec2 a = mesh.vertices[edge.ends[0]].place, b = mesh.vertices[edge.ends[1]].place;
            const glm::dvec2 offset = glm::max(glm::dvec2(a) - glm::dvec2(place), glm::dvec2(place) - glm::dvec2(b));
            const double length = glm::length(glm::dvec2(b) - glm::dvec2(a));
            const bool near = std::max(offset.x, offset.y) < 0.5 * length;
            edge.strong = edge.isLive && near ? 2u : 0u;
        }
        std::vector<std::uint32_t> live;
        const std::uint32_t firstNew = mesh.refine(100000, edges, nodes, live);
        edges = onlyNew ? live : numbersFrom(0, mesh.edges.size());
        nodes = numbersFrom(onlyNew ? firstNew : 0, mesh.nodes.size());
    }
    mesh.settle();
}

/// Four cells, refined about a point in one of them, close to the next.
bake::LaunchMesh refinedMesh(Measured measured = Measured::kOnlyNew) {
    bake::LaunchMesh mesh;
    const bake::LaunchFrame frame = frameOfCells(2);
    for (std::uint32_t cell = 0; cell < 4; ++cell) {
        mesh.addCell(0, frame, cell);
    }
    refineAbout(mesh, {4000, 1000}, 6, measured);
    return mesh;
}

TEST(LaunchMesh, LeavesCoverEveryCellOnce) {
    const bake::LaunchMesh mesh = refinedMesh();
    std::uint64_t area = 0;
    for (const bake::MeshNode& node : mesh.nodes) {
        if (node.isLeaf()) {
            const glm::uvec2 extent = mesh.vertices[node.corners[2]].place - mesh.vertices[node.corners[0]].place;
            area += std::uint64_t(extent.x) * extent.y;
        }
    }
    EXPECT_GT(mesh.nodes.size(), 12u);
    EXPECT_EQ(area, 4ull * bake::LaunchMesh::kCellUnits * bake::LaunchMesh::kCellUnits);
}

/// In a second window about another point, which reaches into leaves of several sizes.
bake::LaunchMesh refinedTwice(Measured measured) {
    bake::LaunchMesh mesh = refinedMesh(measured);
    mesh.beginWindow();
    refineAbout(mesh, {4300, 900}, 6, measured);
    return mesh;
}

TEST(LaunchMesh, IsRefinedByWhatIsNewAsByAllThatThereIs) {
    const bake::LaunchMesh byNew = refinedTwice(Measured::kOnlyNew), byAll = refinedTwice(Measured::kAll);
    EXPECT_GT(byNew.nodes.size(), refinedMesh().nodes.size());
    ASSERT_EQ(byNew.vertices.size(), byAll.vertices.size());
    for (std::size_t i = 0; i < byNew.vertices.size(); ++i) EXPECT_EQ(byNew.vertices[i].place, byAll.vertices[i].place);
    ASSERT_EQ(byNew.nodes.size(), byAll.nodes.size());
    for (std::size_t i = 0; i < byNew.nodes.size(); ++i) EXPECT_EQ(byNew.nodes[i].fine, byAll.nodes[i].fine);
}

TEST(LaunchMesh, WhatOneSideOfAnEdgeHalvesForItselfConforms) {
    bake::LaunchMesh mesh = refinedMesh();
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.makeRay(i);
    }
    int conforming = 0;
    for (const bake::MeshEdge& edge : mesh.edges) {
        if (edge.parent == bake::kNone) {
            continue;
        }
        const bool isSplit = (mesh.edges[edge.parent].split & 2u) != 0;
        // live exactly where the edge that it halves is off, for then both sides have halved it
        EXPECT_EQ((mesh.liveSamples(edge.middle) & 2u) != 0, isSplit);
        conforming += isSplit ? 0 : 1;
    }
    EXPECT_GT(conforming, 0);
}

} // namespace
} // namespace eikonal

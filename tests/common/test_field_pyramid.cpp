// Bricks and clearances against their definitions, by brute force over voxels and bricks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "common/field_pyramid.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

template <class Visit>
void forEachIndex(const glm::ivec3& size, const Visit& visit) {
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) visit(glm::ivec3(i, j, k));
}

int chebyshev(const glm::ivec3& a, const glm::ivec3& b) {
    const glm::ivec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

/// A lattice whose voxels hold arbitrary values of every kind.
Fields arbitraryFields(const glm::ivec3& size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Fields fields;
    fields.lattice = {glm::dvec3(-1.0, 2.0, 0.5), 0.25, size};
    fields.ior = DenseGrid<float>(size, 1.0f);
    fields.interface = DenseGrid<unsigned char>(size, 0);
    fields.sigmaS = DenseGrid<glm::vec3>(size, glm::vec3(0.0f));
    fields.anisotropy = DenseGrid<float>(size, 0.0f);
    fields.opaque = DenseGrid<float>(size, 0.0f);
    fields.cauchyB = DenseGrid<float>(size, 0.0f);
    for (std::size_t v = 0; v < fields.lattice.count(); ++v) {
        fields.ior.values[v] += uniform(random);
        fields.interface.values[v] = uniform(random) < 0.01f ? 255 : 0;
        fields.sigmaS.values[v] = glm::vec3(uniform(random) < 0.01f ? 1.0f : 0.0f);
        fields.opaque.values[v] = uniform(random) < 0.01f ? 0.5f : 0.0f;
        fields.cauchyB.values[v] = uniform(random) < 0.5f ? 0.01f * uniform(random) : 0.0f;
    }
    fields.cauchyGradient = gradientOf(fields.cauchyB, fields.lattice.voxel);
    fields.iorGradient = gradientOf(fields.ior, fields.lattice.voxel);
    return fields;
}

/// A cell of eight voxel centres, as trilinear interpolation uses it, can be reached from a brick if it touches the brick.
bool reaches(const glm::ivec3& brick, const glm::ivec3& voxel) {
    return glm::all(glm::greaterThanEqual(voxel, brick * kBrickVoxels - 1)) &&
           glm::all(glm::lessThanEqual(voxel, brick * kBrickVoxels + kBrickVoxels));
}

class PyramidOfSize : public ::testing::TestWithParam<glm::ivec3> {};

TEST_P(PyramidOfSize, BoundsWhatInterpolationReaches) {
    const Fields fields = arbitraryFields(GetParam(), 1);
    const FieldPyramid pyramid = fieldPyramidOf(fields);
    EXPECT_EQ(pyramid.bricks.size, (GetParam() + 3) / 4);
    forEachIndex(pyramid.bricks.size, [&](const glm::ivec3& index) {
        FieldBrick expected{.iorMin = 9.0f, .iorMax = 0.0f};
        bool first = true;
        glm::vec3 firstSigma(0.0f);
        forEachIndex(fields.lattice.size, [&](const glm::ivec3& voxel) {
            if (!reaches(index, voxel)) return;
            if (first) firstSigma = fields.sigmaS.at(voxel);
            first = false;
            expected.iorMin = std::min(expected.iorMin, fields.ior.at(voxel));
            expected.iorMax = std::max(expected.iorMax, fields.ior.at(voxel));
            expected.gradientMax = std::max(expected.gradientMax, glm::length(fields.iorGradient.at(voxel)));
            const float term = float(1.0 / (0.4 * 0.4) - 1.0 / (0.5876 * 0.5876));  // violet against the d line
            expected.dispersionMax = std::max(expected.dispersionMax, term * fields.cauchyB.at(voxel));
            expected.dispersedGradientMax =
                std::max(expected.dispersedGradientMax, term * glm::length(fields.cauchyGradient.at(voxel)));
            expected.boundary = expected.boundary || fields.interface.at(voxel) != 0;
            expected.scatters = expected.scatters || fields.sigmaS.at(voxel).r > 0.0f;
            expected.evenMatter = expected.evenMatter && fields.sigmaS.at(voxel) == firstSigma;
            expected.opaque = expected.opaque || fields.opaque.at(voxel) > 0.0f;
        });
        const FieldBrick& found = pyramid.bricks.at(index);
        EXPECT_EQ(found.iorMin, expected.iorMin);
        EXPECT_EQ(found.iorMax, expected.iorMax);
        EXPECT_FLOAT_EQ(found.gradientMax, expected.gradientMax);
        EXPECT_FLOAT_EQ(found.dispersionMax, expected.dispersionMax);
        EXPECT_FLOAT_EQ(found.dispersedGradientMax, expected.dispersedGradientMax);
        EXPECT_EQ(found.boundary, expected.boundary);
        EXPECT_EQ(found.scatters, expected.scatters);
        EXPECT_EQ(found.matter, expected.scatters);
        EXPECT_EQ(found.evenMatter, expected.evenMatter);
        EXPECT_EQ(found.opaque, expected.opaque);
    });
}

TEST_P(PyramidOfSize, ClearanceIsTheChebyshevDistance) {
    FieldPyramid pyramid;
    std::mt19937 random(7);
    for (const int outOf : {1, 3, 40}) {  // every brick an obstacle, many, few
        pyramid.bricks = DenseGrid<FieldBrick>(GetParam(), FieldBrick{});
        for (FieldBrick& brick : pyramid.bricks.values) brick.opaque = int(random() % unsigned(outOf)) == 0;
        const auto clearance = clearanceOf(pyramid, [](const FieldBrick& brick) { return brick.opaque; });
        forEachIndex(GetParam(), [&](const glm::ivec3& from) {
            int nearest = 255;
            forEachIndex(GetParam(), [&](const glm::ivec3& to) {
                if (pyramid.bricks.at(to).opaque) nearest = std::min(nearest, chebyshev(from, to));
            });
            EXPECT_EQ(int(clearance.at(from)), nearest);
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, PyramidOfSize,
                         ::testing::Values(glm::ivec3(1), glm::ivec3(2), glm::ivec3(3), glm::ivec3(4, 5, 1),
                                           glm::ivec3(13, 6, 8), glm::ivec3(9, 17, 3)),
                         [](const auto& size) {
                             const glm::ivec3& v = size.param;
                             return std::to_string(v.x) + "x" + std::to_string(v.y) + "x" + std::to_string(v.z);
                         });

TEST(FieldPyramid, EverythingWithinTheClearanceIsHomogeneous) {
    const Scene scene = sceneOf("[domain]\nmax = [1, 0.8, 1.3]\nresolution = 48\n[[object]]\nradius = 0.3\nior = 1.5\n");
    const Fields fields = composeFields(scene);
    const FieldPyramid pyramid = fieldPyramidOf(fields);
    const double limit = negligibleGradient(pyramid, scene.accuracy.tolerance);
    const auto clearance = clearanceOf(pyramid, [&](const FieldBrick& brick) { return brick.gradientMax > limit; });
    int clear = 0;
    forEachIndex(clearance.size, [&](const glm::ivec3& brick) {
        const int distance = clearance.at(brick);
        if (distance == 0) return;
        ++clear;
        // The free box about the brick, and the voxel beyond it that interpolation reaches.
        const glm::ivec3 low = glm::max((brick - (distance - 1)) * kBrickVoxels - 1, glm::ivec3(0));
        const glm::ivec3 high = glm::min((brick + distance) * kBrickVoxels, fields.lattice.size - 1);
        float steepest = 0.0f;
        forEachIndex(high - low + 1, [&](const glm::ivec3& offset) {
            steepest = std::max(steepest, glm::length(fields.iorGradient.at(low + offset)));
        });
        EXPECT_LE(steepest, limit);
    });
    // The ball with its soft edge takes a cube of 2 (0.3 + 5 · 1.5 voxels) on each side: less than a third of the domain.
    EXPECT_GT(clear, int(clearance.values.size()) * 2 / 3);
    EXPECT_LT(clear, int(clearance.values.size()));
}

TEST(FieldPyramid, UniformFieldsHaveNoObstacles) {
    Fields fields;
    fields.lattice = {glm::dvec3(0.0), 1.0, glm::ivec3(6, 1, 9)};
    fields.iorUniform = 1.33f;
    const FieldPyramid pyramid = fieldPyramidOf(fields);
    for (const FieldBrick& brick : pyramid.bricks.values) {
        EXPECT_EQ(brick.iorMin, 1.33f);
        EXPECT_EQ(brick.gradientMax, 0.0f);
        EXPECT_FALSE(brick.matter || brick.opaque || brick.boundary);
    }
    for (const auto distance : clearanceOf(pyramid, [](const FieldBrick& brick) { return brick.matter; }).values)
        EXPECT_EQ(distance, 255);
}

TEST(FieldPyramid, NegligibleGradientKeepsARayWithinTheTolerance) {
    Fields fields;
    fields.lattice = {glm::dvec3(0.0), 0.01, glm::ivec3(100, 100, 50)};
    fields.iorUniform = 1.5f;
    const double tolerance = 0.02;
    const double gradient = negligibleGradient(fieldPyramidOf(fields), tolerance);
    // A ray across a constant gradient is a parabola: off by g s²/(2 n) after a path s, here the diagonal of 1.5.
    EXPECT_NEAR(gradient * 1.5 * 1.5 / (2.0 * 1.5), tolerance * fields.lattice.voxel, 1e-9);
    // At a tolerance below what floats hold, rounding is what counts: sqrt(3) units of 2^-23 to a voxel at most.
    EXPECT_NEAR(negligibleGradient(fieldPyramidOf(fields), 1e-9), std::sqrt(3.0) * 1.5 * 1.1920929e-7 / 0.01, 1e-9);
}

} // namespace
} // namespace eikonal

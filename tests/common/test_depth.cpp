// Where opaque matter begins, between voxels too, and what is left of that where bodies meet.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/depth.h"
#include "common/fields.h"
#include "common/reference/reference_field.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

using glm::dvec3;

constexpr double kSlant = 20.0;  // degrees about z
const dvec3 kAlong(std::cos(glm::radians(kSlant)), std::sin(glm::radians(kSlant)), 0.0);
const dvec3 kUp(-kAlong.y, kAlong.x, 0.0);

/// A box in a frame turned by kSlant about the origin, from `first` to `last` along it and from `bottom` to `top`.
std::string slantedBox(double first, double last, const std::string& matter, double bottom = -0.5, double top = 0.0) {
    const dvec3 middle = 0.5 * (first + last) * kAlong + 0.5 * (bottom + top) * kUp;
    return fmt::format("[[object]]\nshape = \"box\"\nsize = [{}, {}, 1.2]\ntranslate = [{}, {}, 0.013]\n"
                       "rotate = [0, 0, {}]\n{}\n",
                       last - first, top - bottom, middle.x, middle.y, kSlant, matter);
}

Fields fieldsWith(const std::string& objects) { return composeFields(sceneOf("[domain]\nresolution = 40\n" + objects)); }

/// How far above the plane of the boxes' tops the matter begins [voxels].
double surfaceAt(const Fields& fields, double along, double across) {
    const reference::GridField field(fields);
    const double voxel = fields.lattice.voxel;
    double solid = -3.0, free = 3.0;
    for (int i = 0; i < 30; ++i) {
        const double between = 0.5 * (solid + free);
        const bool isSolid = field.opaqueDepth(along * kAlong + dvec3(0.0, 0.0, across) + between * voxel * kUp) >= 0.5;
        (isSolid ? solid : free) = between;
    }
    return solid;
}

/// The farthest that the surface is off the plane, along a stretch of it.
double roughness(const Fields& fields, double first, double last) {
    double most = 0.0;
    for (int i = 0; i <= 200; ++i)
        for (const double across : {-0.2, 0.0, 0.17})
            most = std::max(most, std::abs(surfaceAt(fields, first + (last - first) * i / 200.0, across)));
    return most;
}

const std::string kOpaque = "opaque = true";
constexpr double kRounding = 1e-5;  // voxels: floats of up to three

TEST(Depth, SurfaceOfASlantedBoxIsPlane) {
    EXPECT_LE(roughness(fieldsWith(slantedBox(-0.5, 0.5, kOpaque)), -0.3, 0.3), kRounding);  // of coverage: 0.09
}

TEST(Depth, SecondBodyInTheFirstChangesNothing) {
    const std::string box = slantedBox(-0.5, 0.5, kOpaque);
    EXPECT_LE(roughness(fieldsWith(box + box), -0.3, 0.3), kRounding);
    const Fields withInlay = fieldsWith(box + slantedBox(-0.2, 0.2, kOpaque));
    EXPECT_LE(roughness(withInlay, -0.05, 0.05), kRounding);
    // At its rim the inlay has no one side to face, and half of what it takes counts as its own: still less than the 0.09 voxel that
    // surfaces by coverage are off everywhere.
    EXPECT_LE(roughness(withInlay, -0.35, 0.35), 0.08);
}

TEST(Depth, SeamOfTwoBodiesIsNoGroove) {
    const Fields fields = fieldsWith(slantedBox(-0.5, 0.02, kOpaque) + slantedBox(0.02, 0.5, kOpaque));
    EXPECT_LE(roughness(fields, 0.15, 0.35), kRounding);
    // Next to the seam depth is that in the nearer side of it. Without its part of the voxels there the seam is open.
    EXPECT_LE(roughness(fields, -0.3, 0.3), 0.15);
    const reference::GridField field(fields);
    for (int i = 0; i < 100; ++i)
        EXPECT_GE(field.opaqueDepth(0.02 * kAlong - (0.1 + 0.003 * i) * kUp), 0.9) << "the seam is closed, " << i;
}

TEST(Depth, WhatStandsOnABodyTakesNothingOfIt) {
    const std::string glass = slantedBox(-0.5, 0.5, "ior = 1.5", 0.0, 0.3);
    EXPECT_LE(roughness(fieldsWith(slantedBox(-0.5, 0.5, kOpaque) + glass), -0.3, 0.3), kRounding);
}

TEST(Depth, WhatLiesInABodyTakesItsPlace) {
    const std::string glass = slantedBox(-0.5, 0.5, "ior = 1.5", 0.0, 0.3);
    const Fields fields = fieldsWith(slantedBox(-0.5, 0.5, kOpaque, -0.5, 0.3) + glass);
    EXPECT_LE(roughness(fields, -0.3, 0.3), kRounding);
}

TEST(Depth, SharesAreThoseOfVoxels) {
    const Fields fields = fieldsWith("[[object]]\nradius = 0.6\nopaque = true\n");
    double volume = 0.0;
    for (std::size_t v = 0; v < fields.opaque.values.size(); ++v)
        volume += (1.0 - freeShareAt(fields.opaque, v)) * std::pow(fields.lattice.voxel, 3.0);
    // A ramp a voxel wide in place of the surface: the mean volume of balls whose radii are spread by h²/12 about R.
    const double radius = 0.6, flat = std::pow(fields.lattice.voxel / radius, 2.0) / 4.0;
    const double truth = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3.0) * (1.0 + flat);
    EXPECT_NEAR(volume, truth, 2e-3 * truth);  // of the sum over a lattice as symmetric as the ball, 1e-3 is by chance
}

TEST(Depth, OfSharesAloneIsTheirsAboutTheSurfaceAndGoesOnBeyond) {
    DenseGrid<float> shares(glm::ivec3(16, 1, 1), 0.0f);
    for (int i = 0; i < 16; ++i) shares.at(i, 0, 0) = i < 8 ? 1.0f : i == 8 ? 0.3f : 0.0f;
    const DenseGrid<float> depth = depthFromShares(shares);
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(depth.at(i, 0, 0), i < 5 ? gpu::kMostDepth : i > 11 ? gpu::kLeastDepth : shares.at(i, 0, 0)) << i;
}

} // namespace
} // namespace eikonal

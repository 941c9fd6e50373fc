#pragma once
// The straight edge of a luminous sheet, seen through a lens that is in focus before it: how it blurs is known.

#include <cmath>
#include <numbers>

#include "tests/support/synthetic_fields.h"

namespace eikonal::test {

/// A sheet in the plane z = 0 that shines where x < 0. It lies in nothing, so that rays are straight.
struct DefocusedEdge {
    static constexpr double kDistance = 4.0, kFocus = 3.0, kAperture = 0.9;
    static constexpr double kHalfWidth = 0.25;  ///< of the picture, in the sheet's plane
    static constexpr int kPixels = 33;
    static constexpr double kVoxel = 1.0 / 32.0;

    Fields fields = uniformFields(cube(64, 1.0));
    Scene scene = plainScene(glm::dvec3(0.0), kDistance, glm::degrees(2.0 * std::atan(kHalfWidth / kDistance)), kPixels);

    DefocusedEdge() {
        fields.emission =
            boxGrid(fields.lattice, {-1.0, -1.0, -kVoxel}, {0.0, 1.0, kVoxel}, glm::vec3(float(0.5 / kVoxel)));
        scene.camera.aperture = kAperture;
        scene.camera.focus = kFocus;
        scene.camera.lookAt = glm::dvec3(0.0);
        scene.render.samples = 256;
    }

    /// Share of the lens from which a pixel's centre shows the sheet: that of a disc, whose image in the plane of the sheet is
    /// the circle of confusion of radius a/2 |d/f - 1|, on one side of a chord.
    static double shareOf(int column) {
        const double radius = 0.5 * kAperture * std::abs(kDistance / kFocus - 1.0);
        const double x = kHalfWidth * (2.0 * (column + 0.5) / kPixels - 1.0);
        const double t = glm::clamp(-x / radius, -1.0, 1.0);
        return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / std::numbers::pi;
    }
};

} // namespace eikonal::test

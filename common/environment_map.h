#pragma once
// What surrounds the domain, as cells of a latitude-longitude grid: the pixels of a map, or samples of a gradient. Both
// stages see the environment through this.

#include <limits>
#include <optional>

#include "common/image_io.h"
#include "common/scene.h"

namespace eikonal {

/// The image that a scene's environment names; nothing where it is a gradient. Throws badInput as readImage.
std::optional<Image> environmentImage(const Scene& scene);

/// Cell (x, y): x with longitude as shaders/physics/environment.glsl lays it out, y = 0 at the top.
/// Keeps references to both arguments.
class EnvironmentCells {
public:
    /// `image` is null for a gradient. A larger image than `maxRows` is looked at in every so many rows and columns.
    EnvironmentCells(const Environment& environment, const Image* image,
                     int maxRows = std::numeric_limits<int>::max());

    const glm::ivec2& size() const { return size_; }
    /// Unit vector towards the cell's centre, in the scene's frame.
    glm::dvec3 direction(int x, int y) const;
    /// Intensity included.
    glm::dvec3 radiance(int x, int y) const;
    /// Of each cell of a row [sr]; all of them sum to 4π.
    double solidAngle(int y) const;

private:
    glm::dvec2 centreOf(int x, int y) const { return (glm::dvec2(x, y) + 0.5) / glm::dvec2(size_); }

    const Environment& environment_;
    const Image* image_;
    glm::ivec2 size_;
};

} // namespace eikonal

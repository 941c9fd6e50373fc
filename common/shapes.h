#pragma once
// Shapes as exact signed distances, negative inside. Formulas: I. Quilez, "Distance functions", derived anew.

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "common/scene.h"

namespace eikonal {

/// Distance to a shape's surface from a point in the object's own coordinates, in the object's own unit (that is, before
/// its scale). Safe to call from several threads.
using ShapeDistance = std::function<double(const glm::dvec3&)>;

/// Distance of a shape that has a formula. For fields (their box), meshes and volumes it is broken logic to ask.
ShapeDistance signedDistanceOf(const Shape& shape);

/// A closed curve in the half plane of radius >= 0 and height, revolved about the axis y. Points run from axis to axis;
/// the axis closes the curve but is no surface.
class RevolvedProfile {
public:
    explicit RevolvedProfile(std::vector<glm::dvec2> points);
    double distance(const glm::dvec3& point) const;

private:
    struct Run {
        std::size_t first, last;    ///< segments
        glm::dvec2 low, high;       ///< their bounds
    };
    std::vector<glm::dvec2> points_;
    std::vector<Run> runs_;
};

/// Profiles of a wine glass of that height, standing on -height/2, and of the liquid in it. The liquid reaches to the
/// middle of the wall: listed before the glass, it leaves no gap of air between them, however coverage is smoothed.
std::vector<glm::dvec2> wineGlassProfile(double height);
std::vector<glm::dvec2> wineProfile(double height, double fill);

/// Of the glass of height 1: thickness of the wall, lowest and highest point of the bowl's inside above the foot.
inline constexpr double kGlassWall = 0.03;
inline constexpr double kBowlBottom = 0.455, kBowlTop = 0.985;

} // namespace eikonal

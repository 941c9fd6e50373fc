#pragma once
// The truth that images are judged by: viewing rays in double precision, with the steps of shaders/physics and a loop of
// its own. At the kernels' step it tells their rounding, at a much finer one the error of their step.

#include <functional>

#include "common/baked_light.h"
#include "common/reference/reference_field.h"

namespace eikonal::reference {

/// Radiance or its mean, by direction.
using RadianceOf = std::function<glm::dvec3(const glm::dvec3&)>;

/// What there is to see.
struct ImageScene {
    GridField field;
    const BakedLight* light = nullptr;  ///< nullptr: none
    RadianceOf background;              ///< by unit direction of view
    RadianceOf ambient;                 ///< what a surface of a unit normal receives of it (see ambientOf)
};

struct ImageOptions {
    double stepVoxels = 0.1;      ///< at most 1, or the samples of matter are too few
    double maxPathVoxels = 4096;  ///< a ray that is longer shows the background where it points
    double wavelengthMicrons = 0.5876;  ///< where something disperses; the scene's index is that of the default
    int reflections = 0;          ///< mirrors on a ray's way from the camera that are followed, at most
    double leastReflected = 1e-3; ///< throughput below which a reflection is seen in the environment
};

enum class RayEnd { kMissed, kExited, kHitOpaque, kTooLong };

struct ImageRay {
    glm::dvec3 radiance{0.0};    ///< at the camera
    glm::dvec3 position{0.0};    ///< where it ends
    glm::dvec3 direction{0.0};   ///< there, unit
    glm::dvec3 depth{0.0};       ///< optical depth of extinction
    glm::dvec3 throughput{1.0};  ///< of the background behind
    double opticalLength = 0.0;  ///< integral of n over the path inside the domain [scene units]
    RayEnd end = RayEnd::kMissed;
};

/// Follows a ray against the light, from the camera; `direction` is of any length.
ImageRay followRay(const ImageScene& scene, const glm::dvec3& origin, const glm::dvec3& direction,
                   const ImageOptions& options = {});

/// The viewer's ambient light of a background: its cosine-weighted means about the six axes by quadrature, blended by the
/// squares of the normal's components.
RadianceOf ambientOf(const RadianceOf& background);

} // namespace eikonal::reference

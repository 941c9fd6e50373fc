#pragma once
// A few rays of the lights, and the view ray under the pointer, as lines over the picture.

#include <optional>
#include <vector>

#include "common/gpu/context.h"
#include "viewer/trace.h"
#include "viewer/window/document.h"

namespace eikonal::window {

/// A few rays that a light sends towards the domain: across a beam, or about the way from a position to the middle.
std::vector<TraceRay> raysOfLight(const Light& light, const Lattice& domain);

struct RayPath {
    std::vector<glm::dvec3> points;
    bool ofLight = true;  ///< otherwise the view ray
};

/// Follows the rays of all lights and the view ray through a place of the picture, if one is given. What leaves the domain
/// goes straight on for a while.
std::vector<RayPath> followedRays(const gpu::Context& context, const Document& document,
                                  const std::optional<glm::dvec2>& pointer, double aspect);

void drawRays(const std::vector<RayPath>& paths, const Camera& camera);

} // namespace eikonal::window

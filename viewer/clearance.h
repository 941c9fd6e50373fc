#pragma once
// Where viewing rays may fly straight on (shaders/viewer/flight.glsl): clearances of the field's bricks as a texture, and the
// box of all that is not vacuum.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/effects.h"
#include "common/field_pyramid.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

/// What may change along a viewing ray.
struct FlightRules {
    double tolerance = 0.02;  ///< of a gradient that counts as none (negligibleGradient)
    bool lit = false;         ///< a bake's light varies in matter that scatters
};

class Clearance {
public:
    Clearance(const gpu::Context& context, const Fields& fields, const EffectSet& effects, const FlightRules& rules);

    /// Insets have moved.
    void move(const Fields& fields);
    void configure(gpu::ViewBlock& view) const;
    void bind() const;
    /// "STRAIGHT_FLIGHTS", unless there is no brick in which a ray could fly, and no inset that might leave one.
    std::vector<std::string> defines() const;
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    /// Bounds what the fields hold; clearances of straight flights, brick after brick.
    std::vector<unsigned char> lookAt(const Fields& fields);

    EffectSet effects_;
    FlightRules rules_;
    double negligibleGradient_ = 0.0;
    glm::dvec3 contentMin_, contentMax_;
    std::optional<gpu::Texture3D> texture_;
};

} // namespace eikonal::viewer

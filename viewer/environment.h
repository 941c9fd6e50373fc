#pragma once
// What surrounds the domain: a latitude-longitude map, or a gradient from horizon to zenith (shaders/viewer/background.glsl).

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/image_io.h"
#include "common/scene.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class EnvironmentLight {
public:
    /// Uploads `map`, or takes the gradient of `environment` if there is none. `ambient`: mean radiances for opaque
    /// surfaces are wanted. `means`: of the map over solid angles, for rough boundaries.
    EnvironmentLight(const gpu::Context& context, const Environment& environment, const Image* map, bool ambient, bool means);

    void configure(gpu::ViewBlock& view) const;
    void bind() const;
    /// "ENVIRONMENT_IMAGE" if there is a map.
    std::vector<std::string> defines() const;
    std::vector<std::pair<std::string, std::size_t>> textures() const;

private:
    Environment environment_;
    std::optional<gpu::Texture2D> map_;
    std::array<glm::vec3, 6> ambient_{};
};

} // namespace eikonal::viewer

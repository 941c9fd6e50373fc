#pragma once
// An image of a scene without a window: generate, march, shade, accumulate, tone-map.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/gpu/context.h"
#include "viewer/image.h"
#include "viewer/render_options.h"

namespace eikonal {

/// One channel of the image, row after row from the top.
struct RenderChannel {
    std::string name;
    std::vector<float> values;
};

struct RenderStatistics {
    std::vector<std::pair<std::string, double>> seconds;  ///< by stage, the last one "total"
    std::uint64_t rays = 0;
    std::uint64_t reflectedRays = 0;                      ///< that were followed from the boundaries that reflected them
    double samples = 0.0;                                 ///< of a pixel, the mean over pixels
    double noise = 0.0;                                   ///< relative standard error (viewer/noise.h)
    std::uint64_t steps = 0;                              ///< evaluations after the first of each ray, and look-ups
    std::uint64_t fieldEvaluations = 0;                   ///< of the index field
    std::uint64_t clearanceLookUps = 0;                   ///< how far the next straight flight may go
    std::uint64_t matterSamples = 0;                      ///< of absorption, scattering and emission
    std::vector<std::pair<std::string, std::size_t>> textures;
    std::size_t memoryBytes = 0;                          ///< textures and buffers on the device
    std::optional<std::size_t> marchInstructions;         ///< of the marching kernels, where the driver tells
    std::string device;
};

struct RenderResult {
    glm::ivec2 size{0};
    /// Linear Rec.709 R, G, B, and of the ray through each pixel's centre: exit.X/Y/Z (unit direction at the end),
    /// depth.R/G/B (optical depth of extinction), throughput.R/G/B (of what lies behind), steps, Z (distance to where the
    /// domain is entered, infinite if it is not) and optical_length, both in scene units, and
    /// N.X/Y/Z (outward normal of the opaque surface that the ray ends on, 0 where it meets none). None where the options leave
    /// them out.
    std::vector<RenderChannel> channels;
    std::vector<glm::vec3> display;  ///< tone-mapped, sRGB-encoded, 0 to 1
    RenderStatistics statistics;

    const RenderChannel& channel(std::string_view name) const;
    glm::vec3 radiance(int x, int y) const;
};

/// Renders a scene. `bake`: its light, or nullptr for none. Throws badInput for an environment map that cannot be read and
/// for grids beyond the device.
RenderResult renderScene(const gpu::Context& context, const Scene& scene, const Fields& fields,
                         const EffectSet& effects, const BakedLight* bake, const RenderOptions& options = {});

/// All samples of a frame, region after region, so that a film of any size fits the device. `progress` and `channels`: as in
/// RenderOptions. Statistics hold rays, samples and noise only.
RenderResult renderFrame(ProgressiveImage& image, const RenderSettings& settings,
                         const std::function<void(double)>& progress, bool channels);

/// The channels and the display of an image whose region is its whole frame, without statistics.
RenderResult readImage(ProgressiveImage& image);

} // namespace eikonal

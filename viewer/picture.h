#pragma once
// The film as a texture for a screen, by one of several ways to look at it (shaders/viewer/picture.comp.glsl).

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene.h"
#include "shaders/shared/look_block.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

enum class Look { kImage, kRadiance, kSteps, kIrradiance, kDirection, kIndex, kError };

struct LookName {
    Look look;
    std::string_view name, legend;  ///< legend: what its colours are, with the unit
};
inline constexpr std::array<LookName, 7> kLooks{{
    {Look::kImage, "picture", ""},
    {Look::kRadiance, "radiance", "log2 of the mean radiance"},
    {Look::kSteps, "steps", "steps of the ray through the pixel's centre"},
    {Look::kIrradiance, "irradiance slice", "log2 of the mean irradiance"},
    {Look::kDirection, "light direction slice", "x, y, z as red, green, blue; grey is 0"},
    {Look::kIndex, "index slice", "refractive index"},
    {Look::kError, "error estimate", "percent of the radiance that half the accuracy changes"},
}};

struct LookSettings {
    Look look = Look::kImage;
    int sliceAxis = 2;
    double slicePosition = 0.0;  ///< along that axis [scene units]
    double lowest = 0.0, highest = 1.0;  ///< values of the first and the last colour

    bool operator==(const LookSettings&) const = default;
};

class PicturePainter {
public:
    /// `defines`: those of the kernels that shade. Kernels are compiled when first used.
    PicturePainter(const gpu::Context& context, std::vector<std::string> defines, ToneMap curve);

    /// Reads the film, fields and light that are bound; the batch's tile is the picture.
    void run(const RayBatch& batch, const LookSettings& look, const gpu::Texture2D& picture);

private:
    const gpu::Context& context_;
    std::vector<std::string> defines_;
    gpu::Buffer block_;
    std::map<Look, gpu::Kernel> kernels_;
};

} // namespace eikonal::viewer

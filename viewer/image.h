#pragma once
// An image that grows sample by sample: camera, light and size may change in between, and what does not depend on them
// stays on the device. Stills and the window are made by this one path.

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/gpu/pass_timer.h"
#include "common/gpu_fields.h"
#include "viewer/band_passes.h"
#include "viewer/clearance.h"
#include "viewer/environment.h"
#include "viewer/film.h"
#include "viewer/light.h"
#include "viewer/noise.h"
#include "viewer/picture.h"
#include "viewer/ray_pipeline.h"
#include "viewer/render_options.h"
#include "viewer/sampling.h"
#include "viewer/tone_map.h"

namespace eikonal {

class ProgressiveImage {
public:
    /// Uploads the fields and compiles the kernels of the effects that are on. `bake`: its light, or nullptr for none.
    /// Throws badInput for an environment map that cannot be read and for grids beyond the device.
    ProgressiveImage(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                     const BakedLight* bake, const RenderOptions& options);

    /// The pixels of `region` within a frame of that size. Starts over, as all that changes what is seen does.
    void setFrame(const glm::ivec2& size, const viewer::Tile& region);
    void setCamera(const Camera& camera);
    /// Another bake, on any lattice. The image must have been made with one.
    void setLight(const BakedLight& bake);
    /// The fields that the image was made of with its insets elsewhere: their grids, and all others, stay on the device.
    void moveInsets(const Fields& fields);
    /// Arc length of a step, and longest piece on which matter is sampled once [voxels]. Throws badInput for a step that is not
    /// positive.
    void setStep(double stepVoxels, double matterVoxels = 1.0);
    /// Factor 2^ev on what is displayed; the film stays.
    void setExposure(double ev);

    /// Follows the next rays of the round under way, at most `most` of them and never more than options.tileRays nor than
    /// complete the round. How many they were.
    std::size_t addRays(std::size_t most);
    std::size_t mostRays() const { return options_.tileRays; }
    /// Rounds of one ray a pixel that are complete.
    int rounds() const { return round_; }
    /// Rounds that the scene's samples take.
    int mostRounds() const { return sampling_.roundsOf(render_.samples); }
    /// Samples that every pixel has; the film is their mean.
    int samples() const { return sampling_.samplesIn(round_); }
    /// Whether the film has all samples of the scene, or as little noise as it asks for.
    bool isComplete() const { return round_ >= mostRounds() || isQuiet_; }
    viewer::FilmNoise noise() const;
    /// Share of the round under way that is done, 0 to 1.
    double roundProgress() const;

    const viewer::Tile& region() const { return region_; }
    const glm::ivec2& frameSize() const { return batch_.view.imageSize; }
    std::vector<gpu::FilmPixel> film() const;
    /// Calls visit(first, pixels) with the region's pixels, counted row after row, part after part.
    template <class Visit>
    void visitFilm(const Visit& visit) const {
        constexpr std::size_t kPixelsAtATime = 1u << 14;
        std::vector<gpu::FilmPixel> part(std::min(kPixelsAtATime, region_.pixels()));
        for (std::size_t first = 0; first < region_.pixels(); first += part.size()) {
            const auto pixels = std::span(part).first(std::min(part.size(), region_.pixels() - first));
            film_.read(first, pixels);
            visit(first, std::span<const gpu::FilmPixel>(pixels));
        }
    }
    /// One pixel of the region.
    gpu::FilmPixel filmPixel(std::size_t index) const;
    /// Tone-mapped, sRGB-encoded values of the region.
    std::vector<glm::vec4> display();
    /// The region as a texture of its size. `compared`: an image with the same region, for the look that shows the difference.
    void paint(const viewer::LookSettings& look, const gpu::Texture2D& picture, const ProgressiveImage* compared = nullptr);
    /// Marks the passes of what follows; nullptr: none.
    void setTimer(gpu::PassTimer* timer) { timer_ = timer; }
    viewer::RayCounts counts() const { return film_.counts(); }
    /// Instructions of the marching kernels, where the driver tells.
    std::optional<std::size_t> marchInstructions() { return pipeline_->instructions(); }
    /// Reflections followed so far.
    std::uint64_t reflectedRays() const { return pipeline_->reflectedRays(); }
    std::vector<std::pair<std::string, std::size_t>> textures() const;
    std::size_t bufferBytes() const;

private:
    void startOver();
    void configureLight();
    void finishRound();
    void runPass(std::size_t pass);
    std::vector<std::string> allDefines() const;
    void bind();
    void mark(std::string_view pass) const;

    const gpu::Context& context_;
    RenderOptions options_;
    Lattice lattice_;
    RenderSettings render_;
    Camera camera_;
    viewer::Sampling sampling_;
    GpuFields fields_;
    viewer::EnvironmentLight environment_;
    viewer::BandPasses passes_;
    bool hasGreyMatter_;
    viewer::Light light_;
    std::optional<viewer::Clearance> clearance_;
    viewer::RayBatch batch_;
    std::unique_ptr<viewer::RayPipeline> pipeline_;
    viewer::Film film_;
    viewer::ToneMapper toneMap_;
    viewer::PicturePainter painter_;
    gpu::PassTimer* timer_ = nullptr;
    viewer::Tile region_;
    int round_ = 0;
    std::size_t pixelsDone_ = 0;  ///< of the round under way
    bool isQuiet_ = false;        ///< as little noise as the scene asks for
};

} // namespace eikonal

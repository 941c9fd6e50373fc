#pragma once
// The picture that the window shows: coarse at once after a change, then more detailed frame by frame, up to what
// `eikonal render` makes of the scene.

#include <optional>
#include <vector>

#include "viewer/image.h"
#include "viewer/window/governor.h"

namespace eikonal::window {

/// Whether other light is on its way, which makes the picture worthless. Soon: it is left as coarse as it is. Later: no samples
/// beyond the first.
enum class NewLight { kNone, kLater, kSoon };

class Session {
public:
    /// `light`: a bake where effects want light, else nullptr. Keeps a reference to the context.
    Session(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
            const BakedLight* light, double frameSeconds);

    void resize(const glm::ivec2& pixels);
    void setCamera(const Camera& camera);
    void setLight(const BakedLight& light);
    /// As ProgressiveImage::moveInsets.
    void moveInsets(const Fields& fields);
    void setExposure(double ev);
    void setLook(const viewer::LookSettings& look);
    /// An image of the same size that the refined picture is compared with by the look that shows errors; nullptr: none yet.
    /// It must outlive its use.
    void compareWith(const ProgressiveImage* image);

    /// The work of one frame: a whole coarse picture if something has changed, else a part of a better one.
    void advance(NewLight light);
    /// Whether there is any.
    bool hasWork(NewLight light) const;

    /// Whether the picture has every pixel and all samples of the scene.
    bool isRefined() const { return !changed_ && current_.fine && image_.isComplete(); }
    const gpu::Texture2D* picture() const { return picture_ ? &*picture_ : nullptr; }
    const Detail& shown() const { return shown_; }
    int samples() const { return image_.samples(); }
    /// The film at a place of the picture, (0, 0) to (1, 1), where the film is complete.
    std::optional<gpu::FilmPixel> probe(const glm::dvec2& at) const;
    ProgressiveImage& image() { return image_; }
    const ProgressiveImage& image() const { return image_; }
    const std::vector<std::pair<std::string, double>>& passSeconds() const { return timer_.seconds(); }
    /// Seconds of a ray with the scene's own step: the mean over the picture so far, or as last measured where there is none.
    double secondsPerRay() const;
    /// Rays that a frame is enough for.
    std::size_t raysInAFrame() const { return governor_.raysWithin(governor_.frameSeconds(), true); }
    int samplesWanted() const { return samples_; }
    /// Evaluations of the index field for each ray that entered the domain, so far.
    double stepsPerRay() const;

private:
    void begin(const Detail& detail);
    /// Rays until the sample is complete or the time is up; true: it is complete.
    bool followRays(double seconds);
    void paint();
    void repaint();

    const gpu::Context& context_;
    gpu::PassTimer timer_;
    ProgressiveImage image_;
    Governor governor_;
    struct {
        std::size_t rays = 0;
        double seconds = 0.0;
    } measured_;  ///< of the picture that is being made
    double fineStep_;
    int samples_;
    glm::ivec2 fullSize_{1};
    std::size_t mostPixels_;  ///< of a film, by the device's blocks
    Detail current_, shown_;
    bool changed_ = true;
    viewer::LookSettings look_;
    const ProgressiveImage* compared_ = nullptr;
    std::optional<gpu::Texture2D> picture_;
};

} // namespace eikonal::window

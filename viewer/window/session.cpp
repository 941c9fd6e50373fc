#include "viewer/window/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/accuracy.h"

namespace eikonal::window {

namespace {

using Clock = std::chrono::steady_clock;

// A coarse ray takes steps of twice the length. Longer ones would pass boundaries without being bent by them.
constexpr double kCoarseStep = 2.0;
constexpr double kCoarseMatter = 2.0;  // voxels between samples of matter, which takes most of a ray's time in smoke
constexpr double kCoarseCost = 0.5;    // of a fine ray

constexpr double kNoLimit = 3600.0;  // seconds

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The size with the same shape that has at most so many pixels.
glm::ivec2 limited(const glm::ivec2& size, std::size_t mostPixels) {
    const double pixels = double(size.x) * double(size.y);
    const double scale = std::min(1.0, std::sqrt(double(mostPixels) / pixels));
    return glm::max(glm::ivec2(glm::dvec2(size) * scale), glm::ivec2(1));
}

} // namespace

Session::Session(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                 const BakedLight* light, double frameSeconds)
    : context_(context), timer_(context), image_(context, scene, fields, effects, light, {}),
      governor_(frameSeconds, kCoarseCost), fineStep_(stepVoxelsOf(scene.accuracy)), samples_(scene.render.samples),
      mostPixels_(context.limits().maxStorageBlockBytes / sizeof(gpu::FilmPixel)) {
    image_.setTimer(&timer_);
}

void Session::resize(const glm::ivec2& pixels) {
    const glm::ivec2 size = limited(glm::max(pixels, glm::ivec2(1)), mostPixels_);
    changed_ = changed_ || size != fullSize_;
    fullSize_ = size;
}

void Session::setCamera(const Camera& camera) {
    image_.setCamera(camera);
    changed_ = true;
}

void Session::setLight(const BakedLight& light) {
    image_.setLight(light);
    changed_ = true;
}

void Session::moveInsets(const Fields& fields) {
    image_.moveInsets(fields);
    changed_ = true;
}

void Session::setExposure(double ev) {
    image_.setExposure(ev);
    repaint();
}

void Session::setLook(const viewer::LookSettings& look) {
    if (look == look_) return;
    look_ = look;
    repaint();
}

void Session::compareWith(const ProgressiveImage* image) {
    if (image == compared_) return;
    compared_ = image;
    repaint();
}

void Session::repaint() {
    if (image_.samples() > 0) {
        paint();
    } else {
        changed_ = true;
    }
}

void Session::begin(const Detail& detail) {
    current_ = detail;
    measured_ = {};
    if (detail.fine) {
        image_.setStep(fineStep_);
    } else {
        image_.setStep(kCoarseStep * fineStep_, kCoarseMatter);
    }
    image_.setFrame(detail.size, {{0, 0}, detail.size});
}

bool Session::followRays(double seconds) {
    const auto start = Clock::now();
    const int before = image_.rounds();
    double used = 0.0;
    while (image_.rounds() == before && used < seconds) {
        const std::size_t rays = image_.addRays(governor_.raysWithin(seconds - used, current_.fine));
        glFinish();  // what rays cost is known when they are done
        const double now = secondsSince(start);
        governor_.measured(rays, current_.fine, now - used);
        measured_.rays += rays;
        measured_.seconds += now - used;
        used = now;
    }
    return image_.rounds() > before;
}

void Session::paint() {
    if (!picture_ || picture_->size() != current_.size) {
        picture_.emplace(context_, gpu::TexelFormat::kRgba8, current_.size, "picture");
    }
    viewer::LookSettings look = look_;
    const bool compares = look.look == viewer::Look::kError && compared_ && isRefined();
    if (look.look == viewer::Look::kError && !compares) look.look = viewer::Look::kImage;
    image_.paint(look, *picture_, compares ? compared_ : nullptr);
    shown_ = current_;
}

bool Session::hasWork(NewLight light) const {
    const bool isWhole = current_.fine && image_.samples() > 0;
    const bool waits = light == NewLight::kSoon || (light == NewLight::kLater && isWhole);
    return changed_ || (!isRefined() && !waits);
}

void Session::advance(NewLight light) {
    if (changed_) {
        begin(governor_.moving(fullSize_));
        followRays(kNoLimit);
        changed_ = false;
        paint();
    } else if (hasWork(light)) {
        if (image_.samples() > 0 && !current_.fine) begin(Governor::refined(current_, fullSize_));
        if (followRays(governor_.frameSeconds())) paint();
    }
    timer_.endFrame();
}

std::optional<gpu::FilmPixel> Session::probe(const glm::dvec2& at) const {
    if (image_.samples() == 0) return std::nullopt;
    const glm::ivec2 size = image_.region().size;
    const glm::ivec2 pixel = glm::clamp(glm::ivec2(at * glm::dvec2(size)), glm::ivec2(0), size - 1);
    return image_.filmPixel(std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x));
}

double Session::secondsPerRay() const {
    const bool isKnown = current_.fine && measured_.rays > 0;
    return isKnown ? measured_.seconds / double(measured_.rays) : governor_.secondsPerRay(true);
}

double Session::stepsPerRay() const {
    const viewer::RayCounts counts = image_.counts();
    return counts.entered == 0 ? 0.0 : double(counts.evaluations) / double(counts.entered);
}

} // namespace eikonal::window

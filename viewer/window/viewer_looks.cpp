// Ways to look at what is there.
#include <cmath>
#include <utility>

#include "viewer/window/look_range.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

constexpr double kFrontPassesPerSecond = 0.25;  // through the domain

} // namespace

void Viewer::chooseLook(viewer::LookSettings look) {
    if (look.look != look_.look) look = withRange(look, *document_.image().fields, light_ ? &light_->light : nullptr);
    if (look.sliceAxis != look_.sliceAxis) look.slicePosition = middleOf(domain(), look.sliceAxis);
    if (look.look != viewer::Look::kError) dropEstimate();
    look_ = look;
    session_->setLook(look);
}

void Viewer::followRaysAtRest() {
    std::optional<glm::dvec2> pointer;
    if (!gui_.wantsMouse()) pointer = placeOf(controls_.pointer());
    if (!isSettled() || (!rayPaths_.empty() && pointer == rayPointer_)) return;
    rayPaths_ = followedRays(window_.context(), document_, pointer, aspect());
    rayPointer_ = pointer;
}

void Viewer::followFronts() {
    if (!overlays_.fronts) {
        fronts_.stop();
        frontsAreStale_ = true;
    } else if (frontsAreStale_ && !bake_.isBusy()) {
        fronts_.start(scene());
        frontsAreStale_ = false;
    }
    if (overlays_.frontsMove && fronts_.fronts()) {
        overlays_.frontTime = std::fmod(overlays_.frontTime + kFrontPassesPerSecond * tick(), 1.0);
    }
}

void Viewer::estimateError() {
    if (!estimates() || !session_->isRefined() || bake_.isBusy()) return;
    if (document_.wantsLight() && !roughLight_) {
        if (!std::exchange(roughIsAsked_, true)) {
            bake_.start({scene(), document_.light().fields, document_.light().effects, keyframe_, true});
        }
        return;
    }
    const BakedLight* light = document_.wantsLight() ? &roughLight_->light : nullptr;
    if (!estimate_) {
        estimate_ = std::make_unique<ErrorEstimate>(window_.context(), scene(), *document_.image().fields, document_.image().effects, light,
                                                    session_->shown().size);
    }
    if (estimate_->isDone()) return;
    estimate_->addRays(session_->raysInAFrame());
    if (!estimate_->isDone()) return;
    pictureError_ = estimate_->differenceFrom(session_->image());
    if (light) lightError_ = differenceOf(light_->light, *light);
    session_->compareWith(&estimate_->image());
}

void Viewer::dropEstimate() {
    if (session_) session_->compareWith(nullptr);
    estimate_.reset();
    pictureError_.reset();
    lightError_.reset();
}

AccuracyReport Viewer::accuracyReport() const {
    const double pixels = double(pixels_.x) * double(pixels_.y);
    AccuracyReport report{pictureError_, lightError_, session_->secondsPerRay() * pixels * session_->samplesWanted(), {}};
    if (light_ && light_->stage == LightStage::kScene) report.lightSeconds = light_->statistics.seconds.total;
    return report;
}

} // namespace eikonal::window

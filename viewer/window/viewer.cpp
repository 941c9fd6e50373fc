#include "viewer/window/viewer.h"

#include <fmt/core.h>

#include "common/interrupt.h"
#include "common/output_file.h"
#include "viewer/window/look_range.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

std::optional<Script> scriptIn(const std::filesystem::path& recording) {
    return recording.empty() ? std::nullopt : std::optional<Script>(readEvents(recording));
}

} // namespace

// What is wrong with a recording or a scene is said before a window opens.
Viewer::Viewer(const ViewOptions& options)
    : options_(options), script_(scriptIn(options.script)), document_(options.file, options.overrides),
      window_(document_.scene().render.size, "Eikonal: " + options.file.filename().string(), {.shaderFolder = options.shaders}),
      screen_(window_.context(), "viewer/window/screen.vert.glsl", "viewer/window/screen.frag.glsl"),
      bake_({.shaderFolder = options.shaders}), fronts_({.shaderFolder = options.shaders}), pixels_(window_.pixels()) {
    look_.slicePosition = middleOf(domain(), look_.sliceAxis);
    session_ = sessionFor(document_, OldLight::kStays);
    watchFiles();
    oldestRequest_ = startBake();
    const bool hasLamps = !scene().lights.empty();
    const std::string start = hasLamps ? "Drag the lamp to move the light, drag elsewhere" : "Drag";
    say(start + " to turn the view. H lists the keys.", false);
}

bool Viewer::frame() {
    throwIfInterrupted();
    cameraMoved_ = false;
    takeEvents();
    followFiles();
    advanceTime();
    takeLight();
    if (const glm::ivec2 size = window_.pixels(); size.x > 0 && size.y > 0) {
        if (size != pixels_) pictureChanges();
        pixels_ = size;
        session_->resize(size);
        attempt([&] { session_->advance(newLight()); });
        if (session_->isRefined()) costs_.measured(document_.image().effects, session_->secondsPerRay());
        estimateError();
        followFronts();
        saveWhenSettled();
        draw();
    }
    window_.context().throwIfError();
    ++frameNumber_;
    noteResponse();
    return !closing_;
}

void Viewer::noteResponse() {
    const Instant now = instantNow();
    const Instant took = now - frameStart_;
    response_.frameEnded(took, session_->shown().size, cameraMoved_);
    if (light_) response_.lightShown(light_->request, now);
    if (isSettled()) response_.refined(now);
    frameSeconds_ = took.clock;
}

bool Viewer::isSettled() const {
    const bool estimated = !estimates() || (estimate_ && estimate_->isDone());
    return session_->isRefined() && !bake_.isBusy() && !stillIsWanted_ && !lightFileWanted_ && estimated && !fronts_.isBusy();
}

void Viewer::finish() const {
    if (options_.record.empty()) return;
    std::string text;
    for (const Event& event : recorded_) text += eventText(event) + "\n";
    text += fmt::format("{} quit\n", frameNumber_);
    writeFile(options_.record, text);
}

ResponseRecord viewScene(const ViewOptions& options) {
    if (!options.record.empty()) requireWritable(options.record);
    Viewer viewer(options);
    while (viewer.frame()) {
    }
    viewer.finish();
    return viewer.response();
}

} // namespace eikonal::window

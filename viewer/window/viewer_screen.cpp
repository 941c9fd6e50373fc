// The screen.
#include "viewer/window/front_overlay.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

std::size_t memoryOf(const ProgressiveImage& image) {
    std::size_t bytes = image.bufferBytes();
    for (const auto& [name, textureBytes] : image.textures()) bytes += textureBytes;
    return bytes;
}

} // namespace

void Viewer::draw() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels_.x, pixels_.y);
    if (const gpu::Texture2D* picture = session_->picture()) {
        picture->bind(0);
        screen_.draw();
    }
    gui_.begin(pixels_, tick());
    if (keyList_) {
        drawKeyList();
    } else if (panels_) {
        drawOverlays();
        drawPanels();
    }
    if (!message_.empty()) drawMessage(message_, messageIsError_);
    gui_.draw();
    takeScreenshots();
    window_.show();
}

void Viewer::drawOverlays() {
    if (overlays_.rays) {
        followRaysAtRest();
        drawRays(rayPaths_, scene().camera);
    }
    if (const auto fronts = fronts_.fronts()) {
        const double last = double(fronts->size() - 1);
        drawFront((*fronts)[std::size_t(overlays_.frontTime * last + 0.5)], scene().camera);
    }
    const auto held = controls_.drag() == Controls::Drag::kLight ? controls_.light() : lightUnderPointer();
    drawHandles(scene(), domain(), scene().camera, handleRoom(), held);
}

void Viewer::drawPanels() {
    numbersCorner_ = drawHud(hudState());
    const double pixels = double(pixels_.x) * double(pixels_.y);
    const auto cost = [&](Effect effect) -> std::optional<double> {
        const auto perRay = costs_.cost(document_.image().effects, effect);
        return perRay ? std::optional(*perRay * pixels) : std::nullopt;
    };
    answerPanel(panel_.draw({scene(), document_.image().effects, domain(), look_, overlays_, accuracyReport(), cost}));
}

void Viewer::answerPanel(const PanelAnswer& answer) {
    if (answer.look != look_) chooseLook(answer.look);
    overlays_ = answer.overlays;
    apply(answer.overrides);
    if (answer.save) attempt([&] { saveWished(*answer.save); });
}

std::string Viewer::lightState() const {
    if (!document_.wantsLight()) return "none to see";
    if (!light_) return "none yet";
    return light_->stage == LightStage::kCoarse ? "coarse" : "refined";
}

HudState Viewer::hudState() const {
    HudState state;
    state.frameSeconds = frameSeconds_;
    state.pictureSize = session_->shown().size;
    state.screenSize = pixels_;
    state.samples = session_->shown().fine ? session_->samples() : 0;
    state.samplesWanted = session_->samplesWanted();
    state.stepsPerRay = session_->stepsPerRay();
    state.passSeconds = session_->passSeconds();
    state.lightState = lightState();
    if (bake_.isBusy()) state.bakeProgress = bake_.progress();
    state.memoryBytes = memoryOf(session_->image()) + (light_ ? light_->statistics.memoryBytes : 0);
    if (!gui_.wantsMouse()) state.probe = session_->probe(placeOf(controls_.pointer()));
    state.slice = probeSlice(look_, scene().camera, placeOf(controls_.pointer()), aspect(), *document_.light().fields,
                             light_ ? &light_->light : nullptr);
    if (state.slice && gui_.wantsMouse()) state.slice->values.clear();
    return state;
}

} // namespace eikonal::window

// The screen, and files that are saved.
#include <fmt/core.h>

#include "common/image_io.h"
#include "common/output_file.h"
#include "common/scene_toml.h"
#include "viewer/image_file.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

/// The first of `stem`_0001, `stem`_0002, ... that none of the extensions has a file for.
std::filesystem::path freeName(const std::filesystem::path& stem, std::initializer_list<const char*> extensions) {
    for (int number = 1;; ++number) {
        const std::string name = fmt::format("{}_{:04d}", stem.string(), number);
        bool taken = false;
        for (const char* extension : extensions) taken = taken || std::filesystem::exists(name + extension);
        if (!taken) return name;
    }
}

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
    if (panels_) drawPanels();
    if (keyList_) drawKeyList();
    if (!message_.empty()) drawMessage(message_, messageIsError_);
    gui_.draw();
    takeScreenshots();
    window_.show();
}

void Viewer::drawPanels() {
    const auto held = controls_.drag() == Controls::Drag::kLight ? controls_.light() : lightUnderPointer();
    if (rays_) {
        followRaysAtRest();
        drawRays(rayPaths_, scene().camera);
    }
    if (!keyList_) drawHandles(scene(), domain(), scene().camera, held);
    drawHud(hudState());
    const double pixels = double(pixels_.x) * double(pixels_.y);
    const auto cost = [&](Effect effect) -> std::optional<double> {
        const auto perRay = costs_.cost(document_.effects(), effect);
        return perRay ? std::optional(*perRay * pixels) : std::nullopt;
    };
    const PanelAnswer answer = panel_.draw({scene(), document_.effects(), domain(), look_, rays_, cost});
    if (answer.look != look_) chooseLook(answer.look);
    rays_ = answer.rays;
    apply(answer.overrides);
}

void Viewer::followRaysAtRest() {
    std::optional<glm::dvec2> pointer;
    if (!gui_.wantsMouse()) pointer = placeOf(controls_.pointer());
    if (!isSettled() || (!rayPaths_.empty() && pointer == rayPointer_)) return;
    rayPaths_ = followedRays(window_.context(), document_, pointer, aspect());
    rayPointer_ = pointer;
}

std::string Viewer::lightState() const {
    if (!document_.wantsLight()) return "none to see";
    if (!light_) return "none yet";
    return light_->coarse ? "coarse" : "refined";
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
    state.memoryBytes = memoryOf(session_->image());
    if (!gui_.wantsMouse()) state.probe = session_->probe(placeOf(controls_.pointer()));
    return state;
}

void Viewer::saveWhenRefined() {
    if (!savePending_ || !session_->isRefined() || bake_.isBusy()) return;
    savePending_ = false;
    const std::filesystem::path name = freeName("eikonal", {".png", ".exr"});
    const RenderResult image = readImage(session_->image());
    writeRendered(name.string() + ".exr", image, attributesOf(image, scene(), options_.creator));
    writeRendered(name.string() + ".png", image, {});
    options_.print(fmt::format("{0}.png, {0}.exr", name.string()));
    say(fmt::format("saved {0}.png and {0}.exr", name.string()), false);
}

void Viewer::saveScene() {
    Scene saved = scene();
    saved.render.size = pixels_;
    const std::filesystem::path stem = saved.folder / document_.file().stem();
    const std::string file = freeName(stem, {".toml"}).string() + ".toml";
    writeFile(file, resolvedToml(saved));
    options_.print(file);
    say("saved " + file, false);
}

void Viewer::takeScreenshots() {
    for (const std::string& file : screenshots_) writeDisplay(file, pixels_, window_.screenshot());
    screenshots_.clear();
}

} // namespace eikonal::window

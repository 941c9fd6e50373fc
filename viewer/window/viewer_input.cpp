// Events to changes.
#include <algorithm>
#include <thread>

#include <fmt/core.h>

#include "common/light_motion.h"
#include "common/scene_toml.h"
#include "viewer/window/light_handle.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

constexpr double kHandleReachPixels = 22.0;
constexpr double kIdleSeconds = 0.25;   // between looks at files where nothing happens
constexpr double kBakingSeconds = 0.05;  // between looks at a bake that works on the same processor
constexpr double kFramesPerSecond = 24.0;   // of keyframes
constexpr double kTurnPerSecond = 0.5;      // radians

/// The camera's section of a scene file.
std::string cameraToml(const Camera& camera) {
    Scene scene;
    scene.camera = camera;
    std::string text = "[camera]";
    for (const WrittenSection& section : writeSections(scene)) {
        if (section.path != "camera") continue;
        for (const auto& [key, value] : section.values) text += fmt::format("\n{} = {}", key, value);
    }
    return text;
}

viewer::LookSettings nextLook(viewer::LookSettings look) {
    look.look = viewer::Look((int(look.look) + 1) % int(viewer::kLooks.size()));
    return look;
}

double lastKeyframe(const Scene& scene) {
    double last = 0.0;
    for (const Light& light : scene.lights) {
        for (const LightKeyframe& keyframe : keyframesOf(light)) last = std::max(last, keyframe.frame);
    }
    return last;
}

} // namespace

double Viewer::secondsToWait() const {
    if (window_.pixels() == glm::ivec2(0) && !script_) return kIdleSeconds;
    const bool estimating = estimates() && estimate_ && !estimate_->isDone();
    const bool moves = plays_ || (overlays_.fronts && overlays_.frontsMove) || controls_.flown(scene().camera, 1.0);
    if (moves || estimating || session_->hasWork(newLight()) || (script_ && !script_->isWaiting())) return 0.0;
    return script_ || bake_.isBusy() || fronts_.isBusy() ? kBakingSeconds : kIdleSeconds;
}

void Viewer::leaveTimeToBake() const {
    const double early = options_.frameSeconds - (instantNow() - frameStart_).clock;
    if (early > 0.0 && bake_.isBusy() && !session_->hasWork(newLight())) {
        std::this_thread::sleep_for(std::chrono::duration<double>(early));
    }
}

void Viewer::takeEvents() {
    leaveTimeToBake();
    std::vector<Event> events = window_.poll(secondsToWait());
    frameStart_ = instantNow();
    if (script_) events = script_->next({isSettled(), readings_});
    for (Event& event : events) {
        event.frame = frameNumber_;
        handle(event);
        if (event.kind != EventKind::kQuit) recorded_.push_back(event);  // the recording ends with one anyway
    }
    dragAlong();
    if (script_ && script_->isDone()) script_.reset();
    closing_ = closing_ || window_.isClosing();
}

void Viewer::handle(const Event& event) {
    gui_.feed(event);
    switch (event.kind) {
        case EventKind::kCursor: controls_.moveTo(event.at); break;
        case EventKind::kButton: handleButton(event); break;
        case EventKind::kScroll:
            if (!gui_.wantsMouse()) setCamera(dollied(scene().camera, event.at.x));
            break;
        case EventKind::kKey: handleKey(event); break;
        case EventKind::kSize: window_.resize(glm::ivec2(event.at)); break;
        case EventKind::kMinimise: window_.minimise(); break;
        case EventKind::kRestore: window_.restore(); break;
        case EventKind::kDrop: attempt([&] { open(event.name); }); break;
        case EventKind::kSave: attempt([&] { save(event.name); }); break;
        case EventKind::kSet: apply({event.name}); break;
        case EventKind::kScreenshot: screenshots_.push_back(event.name); break;
        case EventKind::kQuit: closing_ = true; break;
        case EventKind::kText:
        case EventKind::kWait:
        case EventKind::kChanged: break;
    }
}

void Viewer::handleButton(const Event& event) {
    dragAlong();
    if (event.down && !messageIsError_) say({}, false);
    if (event.down && gui_.wantsMouse()) return;
    controls_.press(event, lightUnderPointer());
}

void Viewer::handleKey(const Event& event) {
    if (event.down && gui_.wantsKeyboard()) return;
    controls_.key(event);
    const Binding* binding = bindingOf(event.name);
    if (event.down && binding) attempt([&] { act(binding->action); });
}

void Viewer::act(Action action) {
    const Camera& camera = scene().camera;
    switch (action) {
        case Action::kFrameAll: return setCamera(framing(camera, domain(), aspect()));
        case Action::kFront: return setCamera(alongAxis(camera, 2));
        case Action::kRight: return setCamera(alongAxis(camera, 0));
        case Action::kAbove: return setCamera(alongAxis(camera, 1));
        case Action::kFullScreen: return window_.toggleFullScreen();
        case Action::kKeyList: keyList_ = !keyList_; return;
        case Action::kPanels: panels_ = !panels_; return;
        case Action::kSaveStill: stillIsWanted_ = true; return;
        case Action::kPrintCamera: return options_.print(cameraToml(camera));
        case Action::kReload: return reload();
        case Action::kPlay: plays_ = !plays_; return;
        case Action::kSaveScene: return saveNumberedScene();
        case Action::kRays: overlays_.rays = !overlays_.rays; return;
        case Action::kFronts: overlays_.fronts = !overlays_.fronts; return;
        case Action::kNextLook: return chooseLook(nextLook(look_));
        case Action::kQuit: closing_ = true; return;
    }
}

void Viewer::dragAlong() {
    if (controls_.drag() == Controls::Drag::kLight) {
        if (*controls_.light() < scene().lights.size()) moveLight(*controls_.light());
    } else if (controls_.drag() != Controls::Drag::kNone) {
        const Camera& camera = scene().camera;
        const Camera dragged = controls_.dragged(camera, pixels_.y);
        if (dragged.position != camera.position || dragged.lookAt != camera.lookAt) setCamera(dragged);
    }
}

void Viewer::advanceTime() {
    if (const auto flown = controls_.flown(scene().camera, tick())) setCamera(*flown);
    if (!plays_) return;
    const double last = lastKeyframe(scene());
    if (last <= 0.0) {
        setCamera(orbited(scene().camera, {kTurnPerSecond * tick(), 0.0}));
        return;
    }
    keyframe_ += kFramesPerSecond * tick();
    if (keyframe_ > last) keyframe_ = 0.0;
    startBake();
}

HandleRoom Viewer::handleRoom() const {
    return panels_ ? roomBesidePanels(pixels_, numbersCorner_) : HandleRoom{.aspect = aspect()};
}

std::optional<std::size_t> Viewer::lightUnderPointer() const {
    return handleUnder(scene(), domain(), scene().camera, placeOf(controls_.pointer()), handleRoom(),
                       kHandleReachPixels / double(pixels_.y));
}

} // namespace eikonal::window

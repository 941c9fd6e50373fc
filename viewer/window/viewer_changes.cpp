// Changes to what depends on them.
#include <algorithm>

#include "common/error.h"
#include "viewer/window/light_handle.h"
#include "viewer/window/look_range.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

constexpr double kSecondsBetweenLooks = 0.5;  // at the files

/// Light for a scene of which none has been baked yet.
BakedLight darkness(const Lattice& domain) {
    Lattice one = domain;
    one.voxel = std::max({domain.extent().x, domain.extent().y, domain.extent().z});
    one.size = glm::ivec3(1);
    return {one, {one.size, glm::vec3(0.0f)}, {one.size, glm::vec3(0.0f)}};
}

} // namespace

void Viewer::setCamera(const Camera& camera) {
    document_.setCamera(camera);
    session_->setCamera(camera);
    costs_.clear();
    rayPointer_.reset();
    cameraMoved_ = true;
    response_.changed(frameStart_);
}

void Viewer::moveLight(std::size_t index) {
    if (!controls_.hasMoved()) return;
    const glm::dvec2 at = placeOf(controls_.pointer());
    document_.setLight(index, draggedTo(scene().lights[index], domain(), scene().camera, at, aspect()));
    if (const std::uint64_t request = startBake(); request > 0) response_.lightDragged(request, frameStart_);
}

void Viewer::apply(const std::vector<std::string>& overrides) {
    for (const std::string& override : overrides) attempt([&] { redo(document_.set(override)); });
}

void Viewer::reload() {
    document_.reload();
    makeSession();
    startBake();
}

void Viewer::followFiles() {
    const auto now = Clock::now();
    if (now - lastLook_ < std::chrono::duration<double>(kSecondsBetweenLooks)) return;
    lastLook_ = now;
    if (document_.filesHaveChanged()) attempt([&] { reload(); });
}

void Viewer::redo(const Redo& redo) {
    if (redo.image) makeSession();
    if (redo.camera) session_->setCamera(scene().camera);
    if (redo.exposure) session_->setExposure(scene().render.exposureEv);
    if (redo.light) startBake();
}

std::uint64_t Viewer::startBake() {
    rayPaths_.clear();
    response_.changed(frameStart_);
    if (!document_.wantsLight()) return 0;
    return bake_.start({scene(), document_.fields(), document_.effects(), playing_.value_or(0.0)});
}

void Viewer::takeLight() {
    if (auto light = bake_.take(); light && document_.wantsLight()) {
        light_ = std::move(*light);
        session_->setLight(light_->light);
    }
    if (const auto error = bake_.takeError()) say(*error, true);
}

void Viewer::makeSession() {
    const BakedLight dark = darkness(domain());
    const BakedLight* light = !document_.wantsLight() ? nullptr : light_ ? &light_->light : &dark;
    auto next = std::make_unique<Session>(window_.context(), scene(), *document_.fields(), document_.effects(), light,
                                          options_.frameSeconds);
    next->resize(pixels_);
    next->setLook(look_);
    session_ = std::move(next);
}

void Viewer::chooseLook(viewer::LookSettings look) {
    if (look.look != look_.look) look = withRange(look, *document_.fields(), light_ ? &light_->light : nullptr);
    if (look.sliceAxis != look_.sliceAxis) look.slicePosition = middleOf(domain(), look.sliceAxis);
    look_ = look;
    session_->setLook(look);
}

void Viewer::attempt(const std::function<void()>& change) {
    try {
        change();
        if (messageIsError_) say({}, false);
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

void Viewer::say(const std::string& text, bool isError) {
    message_ = text;
    messageIsError_ = isError;
}

} // namespace eikonal::window

// Changes to what depends on them.
#include <algorithm>

#include "common/error.h"
#include "viewer/window/light_handle.h"
#include "viewer/window/look_range.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

/// Light for a scene of which none has been baked yet.
BakedLight darkness(const Lattice& domain) {
    Lattice one = domain;
    one.voxel = std::max({domain.extent().x, domain.extent().y, domain.extent().z});
    one.size = glm::ivec3(1);
    return {one, {one.size, glm::vec3(0.0f)}, {one.size, glm::vec3(0.0f)}};
}

} // namespace

void Viewer::pictureChanges() {
    response_.changed(frameStart_);
    dropEstimate();
}

void Viewer::setCamera(const Camera& camera) {
    pictureChanges();
    document_.setCamera(camera);
    session_->setCamera(camera);
    costs_.clear();
    rayPointer_.reset();
    cameraMoved_ = true;
}

void Viewer::moveLight(std::size_t index) {
    if (!controls_.hasMoved()) return;
    const glm::dvec2 at = placeOf(controls_.pointer());
    document_.setLight(index, draggedTo(scene().lights[index], domain(), scene().camera, at, aspect()));
    if (const std::uint64_t request = startBake(); request > 0) response_.lightDragged(request, frameStart_);
}

void Viewer::apply(const std::vector<std::string>& overrides) {
    for (const std::string& override : overrides) attempt([&] { change(override); });
}

void Viewer::change(const std::string& override) {
    Document changed = document_;
    const Redo redo = changed.set(override);
    adopt(std::move(changed), redo);
}

void Viewer::adopt(Document document, const Redo& redo, OldLight oldLight) {
    std::unique_ptr<Session> session = redo.image ? sessionFor(document, oldLight) : nullptr;
    if (session) session->advance(NewLight::kNone);  // kernels are compiled when they are first used
    pictureChanges();
    if (redo.fields || !differInEffectsOnly(scene(), document.scene())) costs_.clear();
    document_ = std::move(document);
    if (oldLight == OldLight::kGoes) light_.reset();
    if (session) {
        session_ = std::move(session);
    } else if (redo.insets) {
        session_->moveInsets(*document_.image().fields);
    }
    if (redo.camera) session_->setCamera(scene().camera);
    if (redo.exposure) session_->setExposure(scene().render.exposureEv);
    if (redo.light) startBake();
    watchFiles();
    if (messageIsError_) say({}, false);
}

std::uint64_t Viewer::startBake() {
    pictureChanges();
    rayPaths_.clear();
    roughLight_.reset();
    roughIsAsked_ = false;
    frontsAreStale_ = true;
    if (!document_.wantsLight()) return 0;
    return bake_.start({scene(), document_.light().fields, document_.light().effects, keyframe_});
}

void Viewer::takeLight() {
    if (auto light = bake_.take(); light && document_.wantsLight() && light->request >= oldestRequest_) {
        if (light->stage == LightStage::kRough) {
            roughLight_ = std::move(*light);
        } else {
            dropEstimate();
            const bool isOfTheOpening = !light_ || light->request == oldestRequest_;
            light_ = std::move(*light);
            session_->setLight(light_->light);
            if (isOfTheOpening && look_.look == viewer::Look::kIrradiance) {  // looked at before there was a range to show
                look_ = withRange(look_, *document_.image().fields, &light_->light);
                session_->setLook(look_);
            }
        }
    }
    if (const auto error = bake_.takeError()) say(*error, true);
}

NewLight Viewer::newLight() const {
    const auto stage = bake_.coming();
    if (!stage || *stage == LightStage::kRough) return NewLight::kNone;
    return *stage == LightStage::kCoarse ? NewLight::kSoon : NewLight::kLater;
}

std::unique_ptr<Session> Viewer::sessionFor(const Document& document, OldLight oldLight) const {
    const BakedLight dark = darkness(document.domain());
    const BakedLight* known = light_ && oldLight == OldLight::kStays ? &light_->light : &dark;
    const BakedLight* light = document.wantsLight() ? known : nullptr;
    auto session = std::make_unique<Session>(window_.context(), document.scene(), *document.image().fields, document.image().effects, light,
                                             options_.frameSeconds);
    session->resize(pixels_);
    session->setLook(look_);
    return session;
}

void Viewer::attempt(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

void Viewer::say(const std::string& text, bool isError) {
    message_ = text;
    messageIsError_ = isError;
    if (isError && script_ && options_.warn) options_.warn(text);  // nobody looks at the window then
}

} // namespace eikonal::window

#pragma once
// All that lives while the window is open, and what may be done to it.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/gpu/screen_program.h"
#include "viewer/window/bindings.h"
#include "viewer/window/controls.h"
#include "viewer/window/document.h"
#include "viewer/window/effect_costs.h"
#include "viewer/window/error_estimate.h"
#include "viewer/window/file_watch.h"
#include "viewer/window/gui.h"
#include "viewer/window/hud.h"
#include "viewer/window/live_bake.h"
#include "viewer/window/live_fronts.h"
#include "viewer/window/panel.h"
#include "viewer/window/ray_overlay.h"
#include "viewer/window/response.h"
#include "viewer/window/script.h"
#include "viewer/window/session.h"
#include "viewer/window/viewer.h"
#include "viewer/window/window.h"

namespace eikonal::window {

class Viewer {
public:
    explicit Viewer(const ViewOptions& options);

    /// One frame: input, what changed outside, a part of the picture, the screen. False: the window is to be closed.
    bool frame();
    /// Writes the recording, where one was asked for.
    void finish() const;
    const ResponseRecord& response() const { return response_.record(); }

private:
    using Clock = std::chrono::steady_clock;

    // viewer_input.cpp: events to changes.
    void takeEvents();
    double secondsToWait() const;
    /// Where there is nothing but light to wait for, frames keep to their pace, however many events there are.
    void leaveTimeToBake() const;
    void handle(const Event& event);
    void handleButton(const Event& event);
    void handleKey(const Event& event);
    void act(Action action);
    void advanceTime();
    void dragAlong();

    // viewer_changes.cpp: changes to what depends on them.
    void setCamera(const Camera& camera);
    void moveLight(std::size_t index);
    void apply(const std::vector<std::string>& overrides);
    void change(const std::string& override);
    void pictureChanges();
    /// Returns the number of the request; 0 where no light is wanted.
    std::uint64_t startBake();
    void takeLight();
    NewLight newLight() const;
    enum class OldLight { kStays, kGoes };
    std::unique_ptr<Session> sessionFor(const Document& document, OldLight oldLight) const;
    /// Shows another state of the scene. Throws badInput where it cannot be shown; everything is then as it was.
    void adopt(Document document, const Redo& redo, OldLight oldLight = OldLight::kStays);
    void attempt(const std::function<void()>& action);
    void say(const std::string& text, bool isError);

    // viewer_files.cpp: files that are read, watched and written.
    void open(const std::string& file);
    void followFiles();
    void reload();
    void watchFiles();
    void saveWhenSettled();
    void saveStill();
    void saveLight(const std::filesystem::path& file);
    void save(const std::filesystem::path& name);
    void saveWished(const SaveWish& wish);
    void saveNumberedScene();
    void takeScreenshots();

    // viewer_looks.cpp: ways to look at what is there.
    void chooseLook(viewer::LookSettings look);
    void followRaysAtRest();
    void followFronts();
    void estimateError();
    void dropEstimate();
    bool estimates() const { return look_.look == viewer::Look::kError; }
    AccuracyReport accuracyReport() const;

    // viewer_screen.cpp: the screen.
    void draw();
    void drawOverlays();
    void drawPanels();
    void answerPanel(const PanelAnswer& answer);
    HudState hudState() const;
    std::string lightState() const;
    void noteResponse();

    bool isSettled() const;
    const Scene& scene() const { return document_.scene(); }
    const Lattice& domain() const { return document_.domain(); }
    double aspect() const { return double(pixels_.x) / double(pixels_.y); }
    HandleRoom handleRoom() const;
    std::optional<std::size_t> lightUnderPointer() const;
    /// Seconds that moves are made by: replayed ones do not depend on the clock.
    double tick() const { return script_ ? 1.0 / 30.0 : frameSeconds_; }
    glm::dvec2 placeOf(const glm::dvec2& pixel) const { return pixel / glm::dvec2(pixels_); }

    ViewOptions options_;
    std::optional<Script> script_;
    Document document_;
    FileWatch watch_;
    Window window_;
    Gui gui_;
    gpu::ScreenProgram screen_;
    LiveBake bake_;
    std::uint64_t oldestRequest_ = 0;       ///< whose light is of the file that is open
    std::optional<LiveLight> light_;
    std::unique_ptr<Session> session_;
    Controls controls_;
    Panel panel_;
    EffectCosts costs_;
    viewer::LookSettings look_;
    Overlays overlays_;
    std::vector<RayPath> rayPaths_;         ///< of the scene at rest; empty: to be followed again
    std::optional<glm::dvec2> rayPointer_;  ///< where the pointer was then
    LiveFronts fronts_;
    bool frontsAreStale_ = true;
    bool roughIsAsked_ = false;             ///< light to compare with, of the lights as they are
    std::optional<LiveLight> roughLight_;
    std::unique_ptr<ErrorEstimate> estimate_;
    std::optional<double> pictureError_;    ///< shares
    std::optional<double> lightError_;
    glm::ivec2 pixels_{1};
    glm::dvec2 numbersCorner_{0.0};         ///< lower right one, in the last frame that showed them [pixels]
    std::vector<Event> recorded_;
    std::vector<std::string> screenshots_;  ///< of this frame
    std::uint64_t frameNumber_ = 0;
    bool plays_ = false;
    double keyframe_ = 0.0;                 ///< frame of the lights' keyframes
    std::uint64_t readings_ = 0;            ///< of files that had changed
    bool panels_ = true, keyList_ = false, closing_ = false;
    bool stillIsWanted_ = false;            ///< once picture and light are refined
    std::optional<std::filesystem::path> lightFileWanted_;  ///< the same
    std::string message_;
    bool messageIsError_ = false;
    Response response_;
    bool cameraMoved_ = false;              ///< in this frame
    double frameSeconds_ = 0.0;             ///< of the last frame, without waiting for input
    Instant frameStart_ = instantNow();
    Clock::time_point lastLook_ = Clock::now();
};

} // namespace eikonal::window

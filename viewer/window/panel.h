#pragma once
// The panel beside the picture: every value of the scene, made from the tables that read and write scenes; effects with
// their costs; ways to look.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/effects.h"
#include "common/scene_toml.h"
#include "viewer/picture.h"
#include "viewer/window/value_edit.h"

namespace eikonal::window {

/// What is drawn over the picture.
struct Overlays {
    bool rays = false;
    bool fronts = false;      ///< the wavefront's patches
    bool frontsMove = true;
    double frontTime = 0.0;   ///< share of its way through the domain
};

/// What the accuracy that was asked for has come to, as far as it is known.
struct AccuracyReport {
    std::optional<double> pictureError, lightError;  ///< shares (error_estimate.h)
    double pictureSeconds = 0.0;
    std::optional<double> lightSeconds;
};

struct SaveWish {
    std::string file;    ///< beside the scene, unless absolute
    bool light = false;  ///< the bake too
};

/// What the panel shows of the program's state.
struct PanelState {
    const Scene& scene;
    const EffectSet& effects;
    const Lattice& domain;
    viewer::LookSettings look;
    Overlays overlays;
    AccuracyReport accuracy;
    std::function<std::optional<double>(Effect)> effectCost;  ///< seconds a picture, where it has been seen on and off
};

/// What a person asked for in it.
struct PanelAnswer {
    std::vector<std::string> overrides;  ///< "key.path=value"
    viewer::LookSettings look;
    Overlays overlays;
    std::optional<SaveWish> save;
};

inline constexpr float kPanelWidth = 330.0f;  ///< pixels, at the right edge of the screen
inline constexpr float kPanelGap = 10.0f;     ///< pixels between panels and the edges of the screen

class Panel {
public:
    PanelAnswer draw(const PanelState& state);

private:
    void sections(const PanelState& state, PanelAnswer& answer);
    void saving(PanelAnswer& answer);

    ValueEdit edit_;
    SaveWish wish_{"scene.toml", false};
};

/// The value of `render.effects` that switches an effect on or off and leaves the others as they are.
std::string effectsOverride(const EffectSet& effects, const Scene& scene, Effect effect, bool on);

} // namespace eikonal::window

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

/// What the panel shows of the program's state.
struct PanelState {
    const Scene& scene;
    const EffectSet& effects;
    const Lattice& domain;
    viewer::LookSettings look;
    bool rays;  ///< whether rays are drawn
    std::function<std::optional<double>(Effect)> effectCost;  ///< seconds a picture, where it has been seen on and off
};

/// What a person asked for in it.
struct PanelAnswer {
    std::vector<std::string> overrides;  ///< "key.path=value"
    viewer::LookSettings look;
    bool rays;
};

inline constexpr float kPanelWidth = 330.0f;  ///< pixels, at the right edge of the screen

class Panel {
public:
    PanelAnswer draw(const PanelState& state);

private:
    void sections(const PanelState& state, PanelAnswer& answer);

    ValueEdit edit_;
};

/// The value of `render.effects` that switches an effect on or off and leaves the others as they are.
std::string effectsOverride(const EffectSet& effects, const Scene& scene, Effect effect, bool on);

} // namespace eikonal::window

#pragma once
// What is drawn over the picture: numbers, the lights' handles, the list of keys, messages.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/lattice.h"
#include "common/scene.h"
#include "shaders/shared/view_blocks.h"
#include "viewer/window/light_handle.h"
#include "viewer/window/slice_probe.h"

namespace eikonal::window {

struct HudState {
    double frameSeconds = 0.0;
    glm::ivec2 pictureSize{0}, screenSize{0};
    int samples = 0, samplesWanted = 1;
    double stepsPerRay = 0.0;
    std::vector<std::pair<std::string, double>> passSeconds;
    std::optional<double> bakeProgress;  ///< 0 to 1 while light is being baked
    std::string lightState;              ///< "none yet", "coarse", "refined", ...
    std::size_t memoryBytes = 0;
    std::optional<gpu::FilmPixel> probe;  ///< of the pixel under the pointer
    std::optional<SliceProbe> slice;      ///< under the pointer, where one is looked at
};

/// Returns the lower right corner of the numbers [pixels].
glm::dvec2 drawHud(const HudState& state);

/// Between the numbers, which end at a corner [pixels], the panel, and a message of one line.
HandleRoom roomBesidePanels(const glm::ivec2& pixels, const glm::dvec2& numbersCorner);

/// Handles of the lights; `highlighted` under the pointer or in the hand.
void drawHandles(const Scene& scene, const Lattice& domain, const Camera& camera, const HandleRoom& room,
                 std::optional<std::size_t> highlighted);

/// The table of bindings and gestures, in the middle of the screen.
void drawKeyList();

/// A message along the lower edge; the error colour for one that says what is wrong.
void drawMessage(const std::string& text, bool isError);

} // namespace eikonal::window

#include "viewer/window/front_overlay.h"

#include <algorithm>
#include <array>

#include <imgui.h>

#include "viewer/window/orbit.h"

namespace eikonal::window {

namespace {

constexpr float kFaintest = 20.0f, kMedian = 70.0f, kBrightest = 230.0f;  // opacity of 255

float meanOf(const glm::vec3& bands) { return (bands.r + bands.g + bands.b) / 3.0f; }

float medianIrradiance(const std::vector<FrontPatch>& front) {
    std::vector<float> values;
    for (const FrontPatch& patch : front) values.push_back(meanOf(patch.irradiance));
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return std::max(*middle, 1e-20f);
}

} // namespace

void drawFront(const std::vector<FrontPatch>& front, const Camera& camera) {
    if (front.empty()) return;
    ImDrawList* canvas = ImGui::GetBackgroundDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const double aspect = double(screen.x) / double(screen.y);
    const float median = medianIrradiance(front);
    for (const FrontPatch& patch : front) {
        std::array<ImVec2, 4> corners;
        bool seen = true;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Projected at = projected(camera, glm::dvec3(patch.corners[i]), aspect);
            seen = seen && at.depth > 0.0;
            corners[i] = ImVec2(float(at.at.x) * screen.x, float(at.at.y) * screen.y);
        }
        if (!seen) continue;
        const float opacity = std::clamp(kMedian * meanOf(patch.irradiance) / median, kFaintest, kBrightest);
        const int red = patch.folded ? 110 : 255, green = patch.folded ? 200 : 205, blue = patch.folded ? 255 : 90;
        canvas->AddConvexPolyFilled(corners.data(), int(corners.size()), IM_COL32(red, green, blue, int(0.5f * opacity)));
        canvas->AddPolyline(corners.data(), int(corners.size()), IM_COL32(red, green, blue, int(opacity)),
                            ImDrawFlags_Closed, 1.0f);
    }
}

} // namespace eikonal::window

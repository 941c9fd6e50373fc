#include "viewer/window/look_range.h"

#include <algorithm>
#include <cmath>

namespace eikonal::window {

namespace {

constexpr double kStopsShown = 10.0;  // of light: a thousandth of the brightest is still a colour

double brightest(const BakedLight& light) {
    float most = 0.0f;
    for (const glm::vec3& e : light.irradiance.values) most = std::max(most, (e.x + e.y + e.z) / 3.0f);
    return std::max(most, 1e-20f);
}

} // namespace

viewer::LookSettings withRange(viewer::LookSettings look, const Fields& fields, const BakedLight* light) {
    look.lowest = 0.0;
    look.highest = 1.0;
    if (look.look == viewer::Look::kSteps) {
        look.highest = 2.0 * glm::length(glm::dvec3(fields.lattice.size));
    } else if (look.look == viewer::Look::kError) {
        look.highest = 10.0;
    } else if (look.look == viewer::Look::kRadiance) {
        look.lowest = -8.0;
        look.highest = 2.0;
    } else if (look.look == viewer::Look::kIndex && !fields.ior.empty()) {
        const auto [low, high] = std::minmax_element(fields.ior.values.begin(), fields.ior.values.end());
        look.lowest = *low;
        look.highest = std::max(*high, *low + 1e-3f);
    } else if (look.look == viewer::Look::kIrradiance && light) {
        look.highest = std::log2(brightest(*light));
        look.lowest = look.highest - kStopsShown;
    }
    return look;
}

double middleOf(const Lattice& domain, int axis) { return 0.5 * (domain.min[axis] + domain.max()[axis]); }

} // namespace eikonal::window

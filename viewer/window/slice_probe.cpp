#include "viewer/window/slice_probe.h"

#include "common/physics.h"
#include "viewer/window/orbit.h"

namespace eikonal::window {

namespace {

/// Where a straight look meets the slice; none beside the domain.
std::optional<glm::dvec3> pointOnSlice(const viewer::LookSettings& look, const Camera& camera, const glm::dvec2& at,
                                       double aspect, const Lattice& domain) {
    const glm::dvec3 ray = rayThrough(camera, at, aspect);
    const f64::SlicePoint point =
        f64::slicePoint(camera.position, ray, look.sliceAxis, look.slicePosition, domain.min, domain.max());
    return point.isMet ? std::optional(point.x) : std::nullopt;
}

template <class Value>
const Value& voxelAt(const DenseGrid<Value>& grid, const Lattice& lattice, const glm::dvec3& point) {
    return grid.at(glm::clamp(glm::ivec3((point - lattice.min) / lattice.voxel), glm::ivec3(0), grid.size - 1));
}

std::vector<float> numbersOf(const glm::vec3& value) { return {value.x, value.y, value.z}; }

} // namespace

bool isSlice(viewer::Look look) {
    return look == viewer::Look::kIndex || look == viewer::Look::kIrradiance || look == viewer::Look::kDirection;
}

std::optional<SliceProbe> probeSlice(const viewer::LookSettings& look, const Camera& camera, const glm::dvec2& at,
                                     double aspect, const Fields& fields, const BakedLight* light) {
    if (!isSlice(look.look)) return std::nullopt;
    const auto point = pointOnSlice(look, camera, at, aspect, fields.lattice);
    if (look.look == viewer::Look::kIndex) {
        SliceProbe probe{"index", {}};
        if (point) probe.values = {fields.ior.empty() ? fields.iorUniform : voxelAt(fields.ior, fields.lattice, *point)};
        return probe;
    }
    const bool isIrradiance = look.look == viewer::Look::kIrradiance;
    SliceProbe probe{isIrradiance ? "irradiance" : "direction", {}};
    if (point && light) {
        probe.values = numbersOf(voxelAt(isIrradiance ? light->irradiance : light->lightDirection, light->lattice, *point));
    }
    return probe;
}

} // namespace eikonal::window

#include "common/scene_summary.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "common/insets.h"
#include "common/scene_hash.h"

namespace eikonal {
namespace {

nlohmann::json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

nlohmann::json latticeJson(const Lattice& lattice) {
    return {{"min", vectorJson(lattice.min)},
            {"max", vectorJson(lattice.max())},
            {"voxel", lattice.voxel},
            {"size", {lattice.size.x, lattice.size.y, lattice.size.z}},
            {"voxels", lattice.count()}};
}

nlohmann::json insetsJson(const Fields& fields) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Inset& inset : fields.insets) {
        const Lattice& lattice = inset.grids->lattice;
        rows.push_back({{"name", inset.label},
                        {"size", {lattice.size.x, lattice.size.y, lattice.size.z}},
                        {"voxel", voxelOf(inset)},
                        {"voxels", lattice.count()},
                        {"bytes", inset.grids->bytes()},
                        {"cut", reachesBeyond(inset, fields.lattice)}});
    }
    return rows;
}

/// Patches of one voxel: those of a beam pass every voxel once.
double beamPatchSteps(const glm::dvec3& size) { return size.x * size.y * size.z; }

/// Those of a point spread, and what is one voxel wide at the far faces has been advanced from the light on.
double pointPatchSteps(const glm::dvec3& size) {
    return (size.y * size.z + size.z * size.x + size.x * size.y) * std::max({size.x, size.y, size.z});
}

double patchSteps(const Light& light, const glm::dvec3& size) {
    if (std::holds_alternative<DirectionalLight>(light))
        return beamPatchSteps(size);
    const auto* rectangle = std::get_if<RectangleLight>(&light);
    return pointPatchSteps(size) * (rectangle ? rectangle->samples : 1);
}

nlohmann::json costJson(const Scene& scene, const Fields& fields, const EffectSet& effects) {
    const glm::dvec3 size(fields.lattice.size);
    const double rays = double(scene.render.size.x) * double(scene.render.size.y) * scene.render.samples;
    double bake = scene.environment.bake ? scene.environment.lights * beamPatchSteps(size) : 0.0;
    for (const Light& light : scene.lights)
        bake += patchSteps(light, size);
    bake = effects.wantsLight(scene) ? bake : 0.0;
    return {{"image_rays", std::llround(rays)},
            {"image_steps", std::llround(rays * std::max({size.x, size.y, size.z}))},
            {"bake_patch_steps", std::llround(bake)}};
}

} // namespace

nlohmann::json effectRows(const EffectSet& effects, const Fields& fields) {
    nlohmann::json rows = nlohmann::json::array();
    for (const EffectDecision& decision : effects.decisions)
        rows.push_back({{"name", effectName(decision.effect)},
                        {"on", decision.on},
                        {"why", decision.why},
                        {"grids", decision.grids},
                        {"bytes", decision.on ? gridBytesOf(decision.effect, fields) : 0}});
    return rows;
}

nlohmann::json sceneSummary(const Scene& scene, const StageFields& stages) {
    const Fields& fields = *stages.image.fields;
    const EffectSet& effects = stages.image.effects;
    std::size_t memory = 0;
    for (const Inset& inset : fields.insets)
        memory += inset.grids->bytes();
    for (const EffectDecision& decision : effects.decisions)
        memory += gridBytesOf(decision.effect, fields);
    return {{"source", scene.source},
            {"hash", sceneHash(scene, *stages.light.fields)},
            {"lattice", latticeJson(fields.lattice)},
            {"insets", insetsJson(fields)},
            {"effects", effectRows(effects, fields)},
            {"memory_bytes", memory},
            {"objects", scene.objects.size()},
            {"lights", scene.lights.size()},
            {"cost", costJson(scene, fields, effects)}};
}

} // namespace eikonal

// The patches of the kernels against the same steps in double precision, corner by corner.
#include "common/gpu_fields.h"
#include "common/physics.h"
#include "common/reference/reference_field.h"
#include "lightsim/settings.h"
#include "lightsim/wavefront.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

constexpr int kRounds = 28;  // the first patches leave the domain after 32

/// The corner that enters at `entry` along +x, after its optical path has grown to t.
glm::dvec3 referencePosition(const reference::GridField& field, const glm::dvec3& entry, double t, double step) {
    f64::Ray ray{entry, glm::dvec3(field.optics(entry).n, 0.0, 0.0)};
    for (double done = 0.0; done < t - 0.5 * step; done += step) {
        ray = f64::driftByOpticalPath(ray, 0.5 * step);
        const reference::Optics optics = field.optics(ray.x);
        ray = f64::driftByOpticalPath(f64::kickByOpticalPath(ray, optics.n, optics.gradN, step), 0.5 * step);
    }
    return ray.x;
}

/// Patches of the first light after kRounds rounds, none of them split.
std::vector<bake::WavefrontPatch> patchesInside(const Fields& fields, const Scene& scene, const bake::Criteria& criteria,
                                                const bake::LaunchGrids& grids) {
    const gpu::Context& context = test::sharedContext();
    const GpuFields gpuFields(context, fields, decideEffects(scene, fields));
    gpuFields.bind();
    const bake::BakeSettings settings = bake::settingsOf(criteria, grids, fields, {});
    std::vector<std::string> defines = gpuFields.defines();
    defines.push_back("BANDS 1");
    bake::Wavefront wavefront(context, defines, grids, settings);
    wavefront.restart(settings);
    for (int round = 0; round < kRounds; ++round) {
        wavefront.emit();
        wavefront.propagate();
        wavefront.refine();
    }
    return wavefront.livePatches();
}

TEST(Wavefront, CornersFollowTheDoublePrecisionSteps) {
    const Lattice lattice = test::cube(32, 1.0);
    const Fields fields = test::sphereFields(lattice, 0.6, 1.5, 1.5 * lattice.voxel);
    const Scene scene = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});
    bake::Criteria criteria = bake::criteriaOf(scene.accuracy, fields);
    criteria.maxSide = 0.25;  // four voxels: few patches, none split
    criteria.splitShare = 1.0;
    const bake::LaunchGrids grids = bake::launchGrids({scene.lights, {}}, lattice, criteria);
    const std::vector<bake::WavefrontPatch> patches = patchesInside(fields, scene, criteria, grids);
    ASSERT_EQ(patches.size(), 64u);
    const reference::GridField field(fields);
    int compared = 0;
    for (const bake::WavefrontPatch& patch : patches) {
        ASSERT_EQ(patch.stepCount, unsigned(kRounds));
        const glm::vec2 launch[4] = {patch.launchMin, {patch.launchMax.x, patch.launchMin.y}, patch.launchMax,
                                     {patch.launchMin.x, patch.launchMax.y}};
        for (int i = 0; i < 4; ++i) {
            if (patch.corners[i].status != PARTICLE_INSIDE) {
                continue;  // bent out through a side face: straight from there on
            }
            const bake::LaunchFrame& frame = grids.frames.front();
            const glm::dvec3 entry(frame.centre + frame.a * launch[i].x + frame.b * launch[i].y);
            const glm::dvec3 expected =
                referencePosition(field, entry, kRounds * criteria.opticalStep, criteria.opticalStep);
            // 28 steps in single precision through gradients of up to 3 per unit
            EXPECT_LT(glm::distance(glm::dvec3(patch.corners[i].x), expected), 1e-4 * lattice.voxel);
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

} // namespace
} // namespace eikonal

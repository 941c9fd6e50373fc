#include "tools/bench/image_case.h"

#include <tbb/parallel_for.h>

#include "common/physics.h"
#include "common/reference/bake_reference.h"
#include "common/reference/image_reference.h"
#include "tools/bench/sampled_field.h"

namespace eikonal::bench {

namespace {

constexpr double kRadius = 0.6, kIrradiance = 3.0;
constexpr double kReferenceStepVoxels = 0.1;
constexpr reference::BeamBakeOptions kBeam{.raysPerVoxelEdge = 16, .stepVoxels = 0.2};

Fields sphereInSmoke(int resolution) {
    const Lattice lattice = cubeLattice(resolution, 1.0);
    const reference::SmoothedSphere sphere(kRadius, 1.5, 1.5 * lattice.voxel);
    Fields fields = sampledField(lattice, [&](const glm::dvec3& x) { return sphere.optics(x).n; });
    fields.sigmaS = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.4f));
    fields.anisotropy = DenseGrid<float>(lattice.size, 0.0f);  // light needs no direction
    return fields;
}

Scene sceneOf(int pixels) {
    Scene scene;
    scene.lights = {DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(kIrradiance), {}}};
    scene.environment.gradient = {glm::dvec3(0.9, 0.6, 0.3), glm::dvec3(0.1, 0.3, 0.8)};
    scene.camera.position = {0.0, 0.0, 4.0};
    scene.camera.fov = 30.0;
    scene.render.size = glm::ivec2(pixels);
    scene.render.toneMap = ToneMap::kNone;
    return scene;
}

BakedLight referenceLight(const Fields& fields) {
    const DenseGrid<glm::dvec3> unit = reference::bakeSymmetricBeam(reference::GridField(fields), fields.lattice, kBeam);
    BakedLight light{fields.lattice, {fields.lattice.size, glm::vec3(0.0f)}, {fields.lattice.size, glm::vec3(0.0f)}};
    std::transform(unit.values.begin(), unit.values.end(), light.irradiance.values.begin(),
                   [](const glm::dvec3& e) { return glm::vec3(kIrradiance * e); });
    return light;
}

} // namespace

ImageCase imageCase(int pixels, int resolution) {
    Fields fields = sphereInSmoke(resolution);
    BakedLight light = referenceLight(fields);
    return {sceneOf(pixels), std::move(fields), std::move(light)};
}

Radiances referenceImage(const ImageCase& seen, int samplesPerEdge) {
    const Scene& scene = seen.scene;
    const auto background = [&](const glm::dvec3& direction) {
        return f64::gradientRadiance(direction, scene.environment.gradient[0], scene.environment.gradient[1]);
    };
    const reference::ImageScene world{reference::GridField(seen.fields), &seen.light, background, background};
    const int size = scene.render.size.x;
    const double half = std::tan(glm::radians(scene.camera.fov) / 2.0);
    Radiances image(std::size_t(size) * std::size_t(size), glm::dvec3(0.0));
    tbb::parallel_for(0, size, [&](int row) {
        for (int i = 0; i < size * samplesPerEdge * samplesPerEdge; ++i) {
            const int column = i / (samplesPerEdge * samplesPerEdge), sample = i % (samplesPerEdge * samplesPerEdge);
            const glm::dvec2 stratum(sample % samplesPerEdge, sample / samplesPerEdge);
            const glm::dvec2 within = (stratum + 0.5) / double(samplesPerEdge);
            const glm::dvec2 screen = 2.0 * (glm::dvec2(column, row) + within) / double(size) - 1.0;
            const glm::dvec3 radiance =
                reference::followRay(world, scene.camera.position, {screen.x * half, -screen.y * half, -1.0},
                                     {.stepVoxels = kReferenceStepVoxels}).radiance;
            image[std::size_t(row * size + column)] += radiance / double(samplesPerEdge * samplesPerEdge);
        }
    });
    return image;
}

} // namespace eikonal::bench

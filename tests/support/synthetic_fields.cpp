#include "tests/support/synthetic_fields.h"

#include <algorithm>
#include <cmath>

namespace eikonal::test {

const gpu::Context& sharedContext() {
    static const gpu::Context context = gpu::Context::windowless();
    return context;
}

Lattice cube(int resolution, double halfEdge) {
    return {glm::dvec3(-halfEdge), 2.0 * halfEdge / resolution, glm::ivec3(resolution)};
}

Fields uniformFields(const Lattice& lattice, double n) {
    Fields fields;
    fields.lattice = lattice;
    fields.iorUniform = float(n);
    return fields;
}

Fields indexFields(const Lattice& lattice, const std::function<double(const glm::dvec3&)>& n) {
    Fields fields = uniformFields(lattice);
    fields.ior = DenseGrid<float>(lattice.size, 1.0f);
    forEachVoxel(lattice, [&](const glm::ivec3& v) { fields.ior.at(v) = float(n(lattice.worldFromIndex(v))); });
    fields.iorGradient = gradientOf(fields.ior, lattice.voxel);
    return fields;
}

Fields sphereFields(const Lattice& lattice, double radius, double index, double width) {
    Fields fields = indexFields(lattice, [&](const glm::dvec3& x) {
        return 1.0 + (index - 1.0) * 0.5 * std::erfc((glm::length(x) - radius) / (std::sqrt(2.0) * width));
    });
    fields.interface = DenseGrid<unsigned char>(lattice.size, 0);
    forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const double distance = std::abs(glm::length(lattice.worldFromIndex(v)) - radius);
        fields.interface.at(v) = distance < 3.0 * width + lattice.voxel ? 255 : 0;
    });
    return fields;
}

Fields dispersing(Fields fields, double cauchyB, double index) {
    fields.cauchyB = fields.ior;
    for (float& value : fields.cauchyB.values) value = float(cauchyB * (double(value) - 1.0) / (index - 1.0));
    fields.cauchyGradient = gradientOf(fields.cauchyB, fields.lattice.voxel);
    return fields;
}

DenseGrid<glm::vec3> boxGrid(const Lattice& lattice, const glm::dvec3& min, const glm::dvec3& max,
                             const glm::vec3& value) {
    const DenseGrid<float> coverage = boxCoverage(lattice, min, max);
    DenseGrid<glm::vec3> grid(lattice.size, glm::vec3(0.0f));
    std::transform(coverage.values.begin(), coverage.values.end(), grid.values.begin(),
                   [&](float share) { return value * share; });
    return grid;
}

DenseGrid<float> boxCoverage(const Lattice& lattice, const glm::dvec3& min, const glm::dvec3& max) {
    DenseGrid<float> grid(lattice.size, 0.0f);
    forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 low = lattice.worldFromIndex(v) - 0.5 * lattice.voxel;
        const glm::dvec3 high = low + lattice.voxel;
        const glm::dvec3 overlap = glm::max(glm::min(high, max) - glm::max(low, min), glm::dvec3(0.0)) / lattice.voxel;
        grid.at(v) = float(overlap.x * overlap.y * overlap.z);
    });
    return grid;
}

double sphereCoverage(const Lattice& lattice, const glm::ivec3& voxel, double radius) {
    const double distance = glm::length(lattice.worldFromIndex(voxel)) - radius;
    return glm::clamp(0.5 - distance / lattice.voxel, 0.0, 1.0);
}

Scene plainScene(const glm::dvec3& surroundings, double cameraDistance, double fov, int size) {
    Scene scene;
    scene.environment.gradient = {surroundings, surroundings};
    scene.camera.position = {0.0, 0.0, cameraDistance};
    scene.camera.lookAt = {0.0, 0.0, cameraDistance - 1.0};
    scene.camera.fov = fov;
    scene.render.size = glm::ivec2(size);
    scene.render.toneMap = ToneMap::kNone;
    return scene;
}

EffectSet effectsOf(const Scene& scene, const Fields& fields) { return decideEffects(scene, fields); }

} // namespace eikonal::test

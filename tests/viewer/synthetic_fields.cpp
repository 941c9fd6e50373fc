#include "tests/viewer/synthetic_fields.h"

#include <cmath>

namespace eikonal::test {

namespace {

template <class Visit>
void forEachVoxel(const Lattice& lattice, const Visit& visit) {
    for (int k = 0; k < lattice.size.z; ++k) {
        for (int j = 0; j < lattice.size.y; ++j) {
            for (int i = 0; i < lattice.size.x; ++i) visit(glm::ivec3(i, j, k));
        }
    }
}

} // namespace

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

DenseGrid<glm::vec3> boxGrid(const Lattice& lattice, const glm::dvec3& min, const glm::dvec3& max,
                             const glm::vec3& value) {
    DenseGrid<glm::vec3> grid(lattice.size, glm::vec3(0.0f));
    forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 low = lattice.worldFromIndex(v) - 0.5 * lattice.voxel;
        const glm::dvec3 high = low + lattice.voxel;
        const glm::dvec3 overlap = glm::max(glm::min(high, max) - glm::max(low, min), glm::dvec3(0.0)) / lattice.voxel;
        grid.at(v) = value * float(overlap.x * overlap.y * overlap.z);
    });
    return grid;
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

glm::dvec4 trilinear(const Fields& fields, const glm::dvec3& x) {
    const glm::dvec3 position = (x - fields.lattice.min) / fields.lattice.voxel - 0.5;
    const glm::dvec3 base = glm::floor(position);
    const glm::dvec3 t = position - base;
    const auto value = [&](int i, int j, int k) {
        const glm::ivec3 v = glm::clamp(glm::ivec3(base) + glm::ivec3(i, j, k), glm::ivec3(0), fields.lattice.size - 1);
        return glm::dvec4(glm::dvec3(fields.iorGradient.at(v)), double(fields.ior.at(v)));
    };
    const auto row = [&](int j, int k) { return glm::mix(value(0, j, k), value(1, j, k), t.x); };
    const auto plane = [&](int k) { return glm::mix(row(0, k), row(1, k), t.y); };
    return glm::mix(plane(0), plane(1), t.z);
}

} // namespace eikonal::test

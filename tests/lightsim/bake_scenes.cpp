#include "tests/lightsim/bake_scenes.h"

namespace eikonal::test {

Scene sceneWith(const Light& light) {
    Scene scene;
    scene.lights = {light};
    return scene;
}

BakeResult bake(const Scene& scene, const Fields& fields, const BakeOptions& options) {
    const gpu::Context& context = sharedContext();
    return bakeScene(context, scene, fields, decideEffects(scene, fields), options);
}

Fields absorbingSphereInSmoke(int resolution) {
    const Lattice lattice = cube(resolution, 1.0);
    Fields fields = sphereFields(lattice, 0.6, 1.5, 1.5 * lattice.voxel);
    fields.sigmaA = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f));
    fields.sigmaS = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f));
    fields.anisotropy = DenseGrid<float>(lattice.size, 0.0f);
    forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const float coverage = float(sphereCoverage(lattice, v, 0.6));
        fields.sigmaA.at(v) = coverage * glm::vec3(0.1f, 0.8f, 0.9f);
        fields.sigmaS.at(v) = glm::vec3(0.4f * (1.0f - coverage));
    });
    return fields;
}

Fields clearSphere(int resolution) {
    const Lattice lattice = cube(resolution, 1.0);
    Fields fields = sphereFields(lattice, 0.6, 1.5, 1.5 * lattice.voxel);
    fields.interface = {};
    return fields;
}

double relativeL1(const DenseGrid<glm::vec3>& a, const DenseGrid<glm::dvec3>& b) {
    double difference = 0.0, total = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        difference += std::abs(double(a.values[i].x) - b.values[i].x);
        total += b.values[i].x;
    }
    return difference / total;
}

} // namespace eikonal::test

#include "tests/lightsim/bake_scenes.h"

#include <algorithm>

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

namespace {

double cubeMean(const Lattice& lattice, const glm::dvec3& centre, const std::function<double(const glm::dvec3&)>& value) {
    const double offset = lattice.voxel / std::sqrt(12.0);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
        sum += value(centre + offset * (2.0 * side - 1.0));
    }
    return sum / 8.0;
}

} // namespace

RelativeErrors errorsAgainst(const BakedLight& light, const std::function<bool(const glm::dvec3&)>& isCompared,
                             const std::function<double(const glm::dvec3&)>& truth) {
    std::vector<double> sizes;
    RelativeErrors errors;
    forEachVoxel(light.lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 centre = light.lattice.worldFromIndex(v);
        if (!isCompared(centre)) return;
        const double error = light.irradiance.at(v).x / cubeMean(light.lattice, centre, truth) - 1.0;
        errors.rms += error * error;
        errors.bias += error;
        sizes.push_back(std::abs(error));
    });
    std::sort(sizes.begin(), sizes.end());
    errors.voxels = int(sizes.size());
    errors.rms = std::sqrt(errors.rms / errors.voxels);
    errors.bias /= errors.voxels;
    errors.median = sizes.empty() ? 0.0 : sizes[sizes.size() / 2];
    return errors;
}

} // namespace eikonal::test

#include "tools/bench/irradiance_cases.h"

#include <numbers>

#include "common/reference/bake_reference.h"
#include "common/reference/plane_interface.h"
#include "tools/bench/index_profiles.h"
#include "tools/bench/sampled_field.h"

namespace eikonal::bench {

namespace {

using PositionFunction = std::function<double(const glm::dvec3&)>;
using PositionTest = std::function<bool(const glm::dvec3&)>;

/// Means over cubes from eight Gauss points, where the voxel's centre `isCompared`.
DenseGrid<double> cubeMeans(const Lattice& lattice, const PositionTest& isCompared, const PositionFunction& irradiance) {
    DenseGrid<double> means(lattice.size, 0.0);
    const double offset = lattice.voxel / std::sqrt(12.0);
    forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 centre = lattice.worldFromIndex(v);
        if (!isCompared(centre)) {
            return;
        }
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
            means.at(v) += irradiance(centre + offset * (2.0 * side - 1.0)) / 8.0;
        }
    });
    return means;
}

IrradianceCase vacuumCase(int resolution) {
    const PointLight light{{0.013, -0.021, 0.017}, glm::dvec3(10.0), {}};
    Fields fields;
    fields.lattice = cubeLattice(resolution, 1.0);
    const auto distance = [light](const glm::dvec3& x) { return glm::distance(x, light.position); };
    DenseGrid<double> truth = cubeMeans(
        fields.lattice, [&](const glm::dvec3& x) { return distance(x) > 0.3 && distance(x) < 0.9; },
        [&](const glm::dvec3& x) { return light.power.x / (4.0 * std::numbers::pi * distance(x) * distance(x)); });
    return {"point light in vacuum", light, std::move(fields), std::move(truth)};
}

/// A unit beam along x in Luneburg's lens. Rays enter at (-√(1 - b²), b) and are x = x0 cos τ + w0 sin τ; the tube's volume is
/// y |∂(x, y)/∂(b, τ)| db dτ dφ.
double luneburgIrradiance(const glm::dvec3& x) {
    const double y = std::max(std::hypot(x.y, x.z), 1e-9);
    const double sine = 0.5 * (x.x + std::sqrt(2.0 - x.x * x.x - 2.0 * y * y)), cosine = std::sqrt(1.0 - sine * sine);
    const double b = y / cosine, a = std::sqrt(1.0 - b * b);
    const double jacobian = b * b / a * cosine * sine + (a * sine + cosine) * cosine;
    return std::sqrt(2.0 - x.x * x.x - y * y) / (cosine * jacobian);
}

IrradianceCase luneburgCase(int resolution) {
    const Luneburg lens;
    Fields fields = sampledField(cubeLattice(resolution, 1.125), [&](const glm::dvec3& x) {
        return glm::dot(x, x) < 1.0 ? lens.optics(x).n : 1.0;
    });
    // off the kink of n at the surface, which voxels know to a voxel, and off the focus
    DenseGrid<double> truth = cubeMeans(
        fields.lattice,
        [](const glm::dvec3& x) { return glm::length(x) < 0.8 && glm::distance(x, {1.0, 0.0, 0.0}) > 0.4; }, luneburgIrradiance);
    return {"Luneburg lens", DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0), {}}, std::move(fields), std::move(truth)};
}

/// A point light in the fish-eye n0/(1 + r²): geodesics of a sphere of radius n0/2, whose wavefronts are circles.
IrradianceCase fishEyeCase(int resolution) {
    const FishEye eye;
    const PointLight light{{0.45, 0.1, -0.05}, glm::dvec3(10.0), {}};
    Fields fields = sampledField(cubeLattice(resolution, 1.0), [&](const glm::dvec3& x) { return eye.optics(x).n; });
    const auto irradiance = [&](const glm::dvec3& x) {
        const glm::dvec3 offset = x - light.position;
        const double s = glm::dot(offset, offset) /
                         ((1.0 + glm::dot(x, x)) * (1.0 + glm::dot(light.position, light.position)));  // sin² of half the angle
        const double n = eye.optics(x).n, radius = 0.5 * eye.n0;
        return light.power.x * n * n / (4.0 * std::numbers::pi * radius * radius * 4.0 * s * (1.0 - s));
    };
    DenseGrid<double> truth = cubeMeans(
        fields.lattice,
        [&](const glm::dvec3& x) { return glm::length(x) < 0.8 && glm::distance(x, light.position) > 0.3; }, irradiance);
    return {"point light in a fish-eye", light, std::move(fields), std::move(truth)};
}

/// A point light before a plane of glass, smoothed as scenes smooth it; compared behind it, in a quarter about the axis.
IrradianceCase interfaceCase(int resolution) {
    const Lattice lattice = cubeLattice(resolution, 1.0);
    const reference::PlaneInterface plane{1.0, 1.5, 1.5 * lattice.voxel};
    const PointLight light{{-0.6, 0.017, -0.023}, glm::dvec3(10.0), {}};
    const auto rho = [light](const glm::dvec3& x) { return std::hypot(x.y - light.position.y, x.z - light.position.z); };
    const double steepest = plane.behind * std::sqrt(0.75);  // 60° from the normal
    // where the index is that of glass to 3e-5, without the outermost voxels, which tubes fill in part where the domain's
    // silhouette clips them
    const double last = 1.0 - lattice.voxel;
    DenseGrid<double> truth = cubeMeans(
        lattice,
        [&](const glm::dvec3& x) {
            return x.x > 4.0 * plane.width && x.y > light.position.y && x.z > light.position.z &&
                   std::max({x.x, x.y, x.z}) < last && plane.waveVectorTowards(0.6, x.x, rho(x)) < steepest;
        },
        [&](const glm::dvec3& x) { return light.power.x * plane.irradianceBehind(0.6, false, x.x, rho(x)); });
    return {"point light before glass", light, sampledField(lattice, [&](const glm::dvec3& x) { return plane.index(x.x); }),
            std::move(truth)};
}

IrradianceCase sphereCase(int resolution) {
    const Lattice lattice = cubeLattice(resolution, 1.0);
    const reference::SmoothedSphere sphere(0.6, 1.5, 1.5 * lattice.voxel);
    Fields fields = sampledField(lattice, [&](const glm::dvec3& x) { return sphere.optics(x).n; });
    const DenseGrid<glm::dvec3> bands = reference::bakeSymmetricBeam(sphere, lattice, {});
    DenseGrid<double> truth(lattice.size, 0.0);
    std::transform(bands.values.begin(), bands.values.end(), truth.values.begin(), [](const glm::dvec3& e) { return e.x; });
    return {"glass sphere", DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0), {}}, std::move(fields), std::move(truth)};
}

} // namespace

std::vector<IrradianceCase> irradianceCases(int resolution) {
    std::vector<IrradianceCase> cases;
    cases.push_back(vacuumCase(resolution));
    cases.push_back(luneburgCase(resolution));
    cases.push_back(fishEyeCase(resolution));
    cases.push_back(interfaceCase(resolution));
    cases.push_back(sphereCase(resolution));
    return cases;
}

} // namespace eikonal::bench

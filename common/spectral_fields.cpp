#include "common/spectral_fields.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/error.h"
#include "common/physics.h"

namespace eikonal {

namespace {

DenseGrid<glm::vec3> inAllBands(const DenseGrid<glm::vec3>& grid, int channel) {
    DenseGrid<glm::vec3> result = grid;
    for (glm::vec3& value : result.values) {
        value = glm::vec3(value[channel]);
    }
    return result;
}

} // namespace

void requireIndexAt(const Fields& fields, double wavelengthMicrons, const std::string& source) {
    const double term = f64::dispersionTerm(wavelengthMicrons);
    for (std::size_t voxel = 0; voxel < fields.cauchyB.values.size(); ++voxel) {
        const double n = fields.ior.empty() ? double(fields.iorUniform) : double(fields.ior.values[voxel]);
        const double dispersed = f64::dispersedIndex(n, fields.cauchyB.values[voxel], term);
        if (!(dispersed > 0.0)) {
            throw badInput(fmt::format("{}: cauchy_b: expected an index above 0 at {:g} nm, found {:g} where ior is {:g} and "
                                       "cauchy_b {:g}",
                                       source, 1000.0 * wavelengthMicrons, dispersed, n, fields.cauchyB.values[voxel]));
        }
    }
}

Fields fieldsOfBand(const Fields& fields, const SpectralBand& band) {
    Fields result = fields;
    const double term = f64::dispersionTerm(band.wavelengthMicrons);
    for (std::size_t voxel = 0; voxel < fields.cauchyB.values.size(); ++voxel) {
        float& n = result.ior.values[voxel];
        n = float(f64::dispersedIndex(n, fields.cauchyB.values[voxel], term));
        glm::vec3& gradient = result.iorGradient.values[voxel];
        gradient = glm::vec3(f64::dispersedGradient(glm::dvec3(gradient), glm::dvec3(fields.cauchyGradient.values[voxel]), term));
    }
    result.cauchyB = {};
    result.cauchyGradient = {};
    for (DenseGrid<glm::vec3> Fields::* constants : {&Fields::sigmaA, &Fields::sigmaS, &Fields::emission, &Fields::albedo}) {
        result.*constants = inAllBands(fields.*constants, band.channel);
    }
    return result;
}

bool isGrey(const DenseGrid<glm::vec3>& grid) {
    return std::all_of(grid.values.begin(), grid.values.end(),
                       [](const glm::vec3& value) { return value.x == value.y && value.y == value.z; });
}

std::vector<SpectralBand> spectralBandsOf(const Accuracy& accuracy, const EffectSet& effects) {
    return effects.has(Effect::kDispersion) ? spectralBands(accuracy.bands) : std::vector<SpectralBand>{};
}

} // namespace eikonal

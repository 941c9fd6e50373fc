#include "common/spectral_fields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/error.h"
#include "common/insets.h"
#include "common/physics.h"

namespace eikonal {

namespace {

constexpr double kLeastRefractivity = 0.01;  // of what disperses most; below it the ratio is not well known
constexpr double kRoundingOfIndex = 1e-6;    // of n, by which voxels may be off the proportion

void requireIndexAt(double n, double cauchyB, double wavelengthMicrons, const std::string& source) {
    const double dispersed = f64::dispersedIndex(n, cauchyB, f64::dispersionTerm(wavelengthMicrons));
    if (!(dispersed > 0.0)) {
        throw badInput(fmt::format("{}: cauchy_b: expected an index above 0 at {:g} nm, found {:g} where ior is {:g} and "
                                   "cauchy_b {:g}",
                                   source, 1000.0 * wavelengthMicrons, dispersed, n, cauchyB));
    }
}

/// Of an inset where the object covers more than half of a voxel, which is where its index is known.
void requireIndexAt(const InsetGrids& grids, double wavelengthMicrons, const std::string& source) {
    if (!grids.has(gpu::kInsetDispersion)) {
        return;
    }
    const auto& coverage = grids.quantities[gpu::kInsetCoverage].varying;
    const auto valueAt = [&](int quantity, std::size_t voxel) {
        const InsetQuantity& of = grids.quantities[std::size_t(quantity)];
        return double(of.varying.empty() ? of.everywhere.w : of.varying[voxel].w / coverage[voxel].w);
    };
    for (std::size_t voxel = 0; voxel < coverage.size(); ++voxel) {
        if (coverage[voxel].w > 0.5f) {
            requireIndexAt(valueAt(gpu::kInsetIndex, voxel), valueAt(gpu::kInsetDispersion, voxel), wavelengthMicrons, source);
        }
    }
}

DenseGrid<glm::vec3> inAllBands(const DenseGrid<glm::vec3>& grid, int channel) {
    DenseGrid<glm::vec3> result = grid;
    for (glm::vec3& value : result.values) {
        value = glm::vec3(value[channel]);
    }
    return result;
}

} // namespace

void requireIndexAt(const Fields& fields, double wavelengthMicrons, const std::string& source) {
    for (std::size_t voxel = 0; voxel < fields.cauchyB.values.size(); ++voxel) {
        const double n = fields.ior.empty() ? double(fields.iorUniform) : double(fields.ior.values[voxel]);
        requireIndexAt(n, fields.cauchyB.values[voxel], wavelengthMicrons, source);
    }
    for (const Inset& inset : fields.insets) {
        requireIndexAt(*inset.grids, wavelengthMicrons, source + ": " + inset.label);
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
    for (DenseGrid<glm::vec3> Fields::* constants :
         {&Fields::sigmaA, &Fields::sigmaS, &Fields::anisotropyByBand, &Fields::emission, &Fields::albedo,
          &Fields::reflectionTint}) {
        result.*constants = inAllBands(fields.*constants, band.channel);
    }
    return result;
}

std::optional<double> cauchyOverRefractivity(const Fields& fields) {
    if (fields.cauchyB.empty() || fields.ior.empty() || !fields.insets.empty()) {
        return std::nullopt;
    }
    const auto strongest = std::max_element(fields.cauchyB.values.begin(), fields.cauchyB.values.end());
    const double refractivity = double(fields.ior.values[std::size_t(strongest - fields.cauchyB.values.begin())]) - 1.0;
    if (std::abs(refractivity) < kLeastRefractivity) {
        return std::nullopt;
    }
    const double ratio = double(*strongest) / refractivity;
    for (std::size_t voxel = 0; voxel < fields.cauchyB.values.size(); ++voxel) {
        const double expected = ratio * (double(fields.ior.values[voxel]) - 1.0);
        if (!(std::abs(expected - double(fields.cauchyB.values[voxel])) <= kRoundingOfIndex * std::abs(ratio))) {
            return std::nullopt;
        }
    }
    return ratio;
}

bool isGrey(const Inset& inset) {
    const auto grey = [](const glm::vec4& value) { return value.x == value.y && value.y == value.z; };
    for (const int quantity : {gpu::kInsetAbsorption, gpu::kInsetScattering, gpu::kInsetAnisotropy, gpu::kInsetOpaque}) {
        const InsetQuantity& of = inset.grids->quantities[std::size_t(quantity)];
        if (!grey(of.everywhere) || !std::all_of(of.varying.begin(), of.varying.end(), grey)) {
            return false;
        }
    }
    return true;
}

bool isGrey(const DenseGrid<glm::vec3>& grid) {
    return std::all_of(grid.values.begin(), grid.values.end(),
                       [](const glm::vec3& value) { return value.x == value.y && value.y == value.z; });
}

std::vector<SpectralBand> spectralBandsOf(const Accuracy& accuracy, const EffectSet& effects) {
    return effects.has(Effect::kDispersion) ? spectralBands(accuracy.bands) : std::vector<SpectralBand>{};
}

} // namespace eikonal

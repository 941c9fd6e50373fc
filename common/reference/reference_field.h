#pragma once
// Fields of a scene for the double-precision reference: what the textures hold, or a closed form.

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <type_traits>

#include <glm/glm.hpp>

#include "common/fields.h"

namespace eikonal::reference {

struct Optics {
    double n = 1.0;
    glm::dvec3 gradN{0.0};  ///< [1 / scene unit]
};

/// Visits the eight voxels about a world position with their trilinear weights, clamped at the faces, as texture units do it.
template <class Visit>
void forEachVoxelAbout(const Lattice& lattice, const glm::dvec3& x, const Visit& visit) {
    const glm::dvec3 place = (x - lattice.min) / lattice.voxel - 0.5;
    const glm::dvec3 lower = glm::floor(place);
    const glm::dvec3 t = place - lower;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - t, t, glm::dvec3(step));
        visit(glm::clamp(glm::ivec3(lower) + step, glm::ivec3(0), lattice.size - 1), w.x * w.y * w.z);
    }
}

/// Value of a dense grid at a world position: trilinear.
template <class Value>
auto trilinear(const DenseGrid<Value>& grid, const Lattice& lattice, const glm::dvec3& x) {
    using Sum = std::conditional_t<std::is_same_v<Value, float>, double, glm::dvec3>;
    Sum sum(0.0);
    forEachVoxelAbout(lattice, x, [&](const glm::ivec3& voxel, double weight) { sum += Sum(grid.at(voxel)) * weight; });
    return sum;
}

/// The composed fields, interpolated as the kernels do it.
class GridField {
public:
    /// The fields must outlive it. `interpolation`, linear or cubic, is that of the index.
    explicit GridField(const Fields& fields, Interpolation interpolation = Interpolation::kLinear);

    /// The same as light of another wavelength than the reference's finds it.
    GridField at(double wavelengthMicrons) const;

    Optics optics(const glm::dvec3& x) const;
    bool inBand(const glm::dvec3& x) const {
        if (fields_.interface.empty()) {
            return false;
        }
        const glm::ivec3 index(glm::floor((x - fields_.lattice.min) / fields_.lattice.voxel));
        return fields_.interface.at(glm::clamp(index, glm::ivec3(0), fields_.lattice.size - 1)) > 127;
    }
    glm::dvec3 sigmaA(const glm::dvec3& x) const { return matter(fields_.sigmaA, x); }
    glm::dvec3 sigmaS(const glm::dvec3& x) const { return matter(fields_.sigmaS, x); }
    glm::dvec3 emission(const glm::dvec3& x) const { return matter(fields_.emission, x); }
    glm::dvec3 albedo(const glm::dvec3& x) const { return matter(fields_.albedo, x); }
    glm::dvec3 anisotropy(const glm::dvec3& x) const {
        return fields_.anisotropyByBand.empty() ? glm::dvec3(share(fields_.anisotropy, x)) : matter(fields_.anisotropyByBand, x);
    }
    /// Depth in opaque matter (shaders/physics/depth.glsl); 0 where there is none at all.
    double opaqueDepth(const glm::dvec3& x) const { return share(fields_.opaque, x); }
    const Lattice& lattice() const { return fields_.lattice; }

private:
    glm::dvec4 index(const glm::dvec3& x) const;  ///< grad n, n
    double share(const DenseGrid<float>& grid, const glm::dvec3& x) const {
        return grid.empty() ? 0.0 : trilinear(grid, fields_.lattice, x);
    }
    glm::dvec3 matter(const DenseGrid<glm::vec3>& grid, const glm::dvec3& x) const {
        return grid.empty() ? glm::dvec3(0.0) : trilinear(grid, fields_.lattice, x);
    }

    const Fields& fields_;
    std::shared_ptr<const DenseGrid<float>> spline_;  ///< coefficients of the index; nullptr: linear
    double dispersionTerm_ = 0.0;                     ///< 1/wavelength² - 1/wavelength_d² [1/µm²]
};

/// Any index in closed form; no matter and no Fresnel terms.
class ClosedForm {
public:
    explicit ClosedForm(std::function<Optics(const glm::dvec3&)> optics) : optics_(std::move(optics)) {}

    Optics optics(const glm::dvec3& x) const { return optics_(x); }
    bool inBand(const glm::dvec3&) const { return false; }
    glm::dvec3 sigmaA(const glm::dvec3&) const { return glm::dvec3(0.0); }
    glm::dvec3 sigmaS(const glm::dvec3&) const { return glm::dvec3(0.0); }

private:
    std::function<Optics(const glm::dvec3&)> optics_;
};

/// The smoothed sphere about the origin, n = 1 + (index - 1) erfc((r - radius)/(sqrt(2) width))/2, in closed form; no
/// matter and no Fresnel terms.
class SmoothedSphere {
public:
    SmoothedSphere(double radius, double index, double width) : radius_(radius), contrast_(index - 1.0), width_(width) {}

    Optics optics(const glm::dvec3& x) const {
        const double r = glm::length(x);
        const double z = (r - radius_) / width_;
        if (std::abs(z) > kFlat) {
            return {z < 0.0 ? 1.0 + contrast_ : 1.0, glm::dvec3(0.0)};
        }
        const double slope = -contrast_ * std::exp(-0.5 * z * z) / (width_ * std::sqrt(2.0 * std::numbers::pi));
        return {1.0 + 0.5 * contrast_ * std::erfc(z / std::numbers::sqrt2), x * (slope / r)};
    }
    bool inBand(const glm::dvec3&) const { return false; }
    glm::dvec3 sigmaA(const glm::dvec3&) const { return glm::dvec3(0.0); }
    glm::dvec3 sigmaS(const glm::dvec3&) const { return glm::dvec3(0.0); }

private:
    static constexpr double kFlat = 8.0;  // widths from the boundary where exp(-z^2/2) is below 1e-13
    double radius_, contrast_, width_;
};

} // namespace eikonal::reference

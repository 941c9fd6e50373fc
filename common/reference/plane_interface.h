#pragma once
// A point light before a smoothed plane interface across x, in closed form. Across the layers of n(x) the tangential wave
// vector k is constant, so that its rays and their tubes are integrals over x:
// ρ = ∫ k dx/√(n² − k²),  dρ/dk = ∫ n² dx/(n² − k²)^{3/2},  E = Φ/(4π) dΩ/(ρ dφ dρ cos θ).

#include <glm/glm.hpp>

namespace eikonal::reference {

struct PlaneInterface {
    double before, behind;  ///< indices for x < 0 and x > 0
    double width;           ///< b of the smoothing [scene units]

    double index(double x) const;
    /// Beyond it erfc is below 1e-9.
    double edge() const { return 6.0 * width; }

    /// Tangential wave vector of the ray from a light at x = -distance that passes rho from the light's axis, at x > edge().
    double waveVectorTowards(double distance, double x, double rho) const;
    /// Irradiance there of a light of unit power; `reflects`: less what a sharp interface reflects of both polarisations.
    double irradianceBehind(double distance, bool reflects, double x, double rho) const;

private:
    struct Tube {
        double rho, slope;  // distance from the axis through the light; dρ/dk
    };
    Tube tubeAt(double distance, double x, double k) const;
};

} // namespace eikonal::reference

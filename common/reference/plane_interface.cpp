#include "common/reference/plane_interface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/physics.h"

namespace eikonal::reference {

namespace {

double cosineOf(double n, double k) { return std::sqrt(1.0 - k * k / (n * n)); }

} // namespace

double PlaneInterface::index(double x) const {
    return behind + (before - behind) * 0.5 * std::erfc(x / (std::numbers::sqrt2 * width));
}

PlaneInterface::Tube PlaneInterface::tubeAt(double distance, double x, double k) const {
    Tube tube{0.0, 0.0};
    const auto add = [&](double n, double dx) {
        const double normal = std::sqrt(n * n - k * k);
        tube.rho += k * dx / normal;
        tube.slope += n * n * dx / (normal * normal * normal);
    };
    constexpr int kLayers = 24;  // flat at both ends, so that equal weights converge exponentially
    const double thickness = 2.0 * edge() / kLayers;
    for (int i = 0; i < kLayers; ++i) {
        add(index((i + 0.5) * thickness - edge()), thickness);
    }
    add(before, distance - edge());
    add(behind, x - edge());
    return tube;
}

/// By Newton's method: ρ(k) is convex, with a pole at the lower index.
double PlaneInterface::waveVectorTowards(double distance, double x, double rho) const {
    const double pole = std::min(before, behind);
    double k = 0.0;
    for (int i = 0; i < 12; ++i) {
        const Tube tube = tubeAt(distance, x, k);
        const double step = std::min((rho - tube.rho) / tube.slope, 0.5 * (pole - k));
        k += step;
        if (std::abs(step) < 1e-12) break;
    }
    return k;
}

double PlaneInterface::irradianceBehind(double distance, bool reflects, double x, double rho) const {
    const double k = waveVectorTowards(distance, x, rho);
    const double solidAngle = k / (before * before * cosineOf(before, k));  // dΩ/(dφ dk)
    const f64::Polarised lost = f64::fresnelReflectance(before, behind, k);
    const double transmitted = reflects ? 1.0 - 0.5 * (lost.s + lost.p) : 1.0;
    return transmitted / (4.0 * std::numbers::pi) * solidAngle / (rho * tubeAt(distance, x, k).slope * cosineOf(behind, k));
}

} // namespace eikonal::reference

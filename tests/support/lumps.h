#pragma once
// A smooth index field by chance, with its gradient in closed form.

#include <cmath>
#include <random>
#include <vector>

#include "common/reference/reference_field.h"

namespace eikonal::test {

/// Three soft lumps of glass in vacuum, within ±0.4, by chance.
struct Lumps {
    struct Lump {
        glm::dvec3 centre;
        double height, width;
    };
    std::vector<Lump> lumps;

    explicit Lumps(unsigned seed) {
        std::mt19937 random(seed);
        const auto between = [&](double low, double high) { return low + (high - low) * (double(random()) / 4294967296.0); };
        for (int i = 0; i < 3; ++i) {
            const double x = between(-0.4, 0.4), y = between(-0.4, 0.4), z = between(-0.4, 0.4);
            const double height = between(0.05, 0.4), width = between(0.12, 0.2);
            lumps.push_back({{x, y, z}, height, width});
        }
    }
    reference::Optics optics(const glm::dvec3& x) const {
        reference::Optics found;
        for (const Lump& lump : lumps) {
            const glm::dvec3 offset = (x - lump.centre) / lump.width;
            const double share = lump.height * std::exp(-0.5 * glm::dot(offset, offset));
            found.n += share;
            found.gradN -= offset * (share / lump.width);
        }
        return found;
    }
};

} // namespace eikonal::test

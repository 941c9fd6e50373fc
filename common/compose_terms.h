#pragma once
// Evaluates quantities of an object wherever it covers voxels, in parallel, and refuses values that are no physics.

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "common/compose_layer.h"
#include "common/error.h"
#include "common/expression.h"
#include "common/scene_limits.h"

namespace eikonal {

/// A quantity with the range that its values must lie in: low < value < high, or also equal to low.
struct Term {
    std::string name;
    const Quantity* quantity = nullptr;
    double low = 0.0, high = kLargestNumber;
    bool lowAllowed = true;

    bool allows(const glm::dvec3& value) const {
        for (int band = 0; band < 3; ++band)
            if (!(lowAllowed ? value[band] >= low : value[band] > low) || !(value[band] < high))
                return false;
        return true;
    }
    std::string expected() const { return fmt::format("{} {:g} and < {:g}", lowAllowed ? ">=" : ">", low, high); }
};

inline Term iorTerm(const Quantity& ior) {
    return {.name = "ior", .quantity = &ior, .low = kLeastIor, .high = kLargestIor, .lowAllowed = false};
}
inline Term notNegative(const std::string& name, const Quantity& quantity) {
    return {.name = name, .quantity = &quantity};
}
inline Term anisotropyTerm(const Quantity& g) {
    return {.name = "anisotropy", .quantity = &g, .low = -1.0, .high = 1.0, .lowAllowed = false};
}

/// A term as one thread evaluates it: its expression if it has one, times the volume's grid of that name.
class TermValue {
public:
    TermValue(const ObjectLayer& layer, const Term& term) : quantity_(*term.quantity), grid_(layer.grid(term.name)) {
        if (quantity_.expression)
            expression_.emplace(*quantity_.expression, quantity_.where);
    }

    glm::dvec3 at(const glm::dvec3& local, std::size_t voxel) const {
        const glm::dvec3 own = expression_ ? glm::dvec3((*expression_)(local)) : quantity_.constant;
        if (!grid_)
            return own;
        const glm::dvec3 given(grid_->values[voxel]);
        return quantity_.given ? own * given : given;
    }

private:
    const Quantity& quantity_;
    const DenseGrid<glm::vec3>* grid_;
    std::optional<Expression> expression_;
};

/// First voxel with a bad value, whatever thread finds it.
class FirstBad {
public:
    void note(std::size_t voxel) {
        std::size_t known = voxel_.load();
        while (voxel < known && !voxel_.compare_exchange_weak(known, voxel)) {
        }
    }
    std::optional<std::size_t> voxel() const {
        return voxel_ == SIZE_MAX ? std::nullopt : std::optional(voxel_.load());
    }

private:
    std::atomic<std::size_t> voxel_{SIZE_MAX};
};

/// Throws badInput naming object, quantity, value and world position if the term is out of range at that voxel.
void requireAllowed(const ObjectLayer& layer, const Term& term, const Lattice& lattice, std::size_t voxel);

/// Coverage below this is nothing: expressions need not make sense there.
inline constexpr double kNoCoverage = 1e-6;

/// Calls apply(voxel, coverage, values of the terms, local position) wherever coverage(voxel) is something.
/// Throws badInput where a value is out of its range.
template <std::size_t kCount, class Coverage, class Apply>
void forCovered(const ObjectLayer& layer, const Lattice& lattice, const std::array<Term, kCount>& terms,
                const Coverage& coverage, const Apply& apply) {
    const glm::dmat4 localFromWorld = glm::inverse(layer.object->worldFromLocal());
    FirstBad bad;
    tbb::parallel_for(0, lattice.size.z, [&](int k) {
        std::vector<TermValue> evaluators;
        for (const Term& term : terms)
            evaluators.emplace_back(layer, term);
        const std::size_t slab = std::size_t(lattice.size.x) * std::size_t(lattice.size.y);
        std::size_t voxel = slab * std::size_t(k);
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i, ++voxel) {
                const double covered = coverage(voxel);
                if (!(covered > kNoCoverage))
                    continue;
                const glm::dvec3 local(localFromWorld * glm::dvec4(lattice.worldFromIndex({i, j, k}), 1.0));
                std::array<glm::dvec3, kCount> values;
                for (std::size_t t = 0; t < kCount; ++t) {
                    values[t] = evaluators[t].at(local, voxel);
                    if (!terms[t].allows(values[t]))
                        bad.note(voxel);
                }
                apply(voxel, covered, values, local);
            }
    });
    if (const auto voxel = bad.voxel())
        for (const Term& term : terms)
            requireAllowed(layer, term, lattice, *voxel);
}

} // namespace eikonal

// What rays conserve, over long paths, by integrator: the Hamiltonian |w| - n, Bouguer's |x × w| in a sphere, the wave vector
// along layers, and the way back. In double precision, on closed forms of n: what is left is the integrator's own.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tools/bench/follow_ray.h"
#include "tools/bench/index_profiles.h"

namespace eikonal {
namespace {

using bench::Method;
using glm::dvec3;

constexpr double kStep = 0.02;

/// Largest deviations of invariants along a path.
struct Deviations {
    double hamiltonian = 0.0;  ///< of |w| - n
    double bouguer = 0.0;      ///< of |x × w|
    double along = 0.0;        ///< of the component of w along y, for layers across x
    f64::Ray end;
};

template <class Field>
Deviations followed(const Field& field, Method method, const f64::Ray& start, int steps, double ds) {
    f64::Stepper<Field> stepper(field);
    Deviations worst{.end = start};
    const double h0 = glm::length(start.w) - field.optics(start.x).n, b0 = glm::length(glm::cross(start.x, start.w));
    for (int i = 0; i < steps; ++i) {
        worst.end = bench::takeStep(stepper, method, worst.end, ds).ray;
        const f64::Ray& ray = worst.end;
        worst.hamiltonian = std::max(worst.hamiltonian, std::abs(glm::length(ray.w) - field.optics(ray.x).n - h0));
        worst.bouguer = std::max(worst.bouguer, std::abs(glm::length(glm::cross(ray.x, ray.w)) - b0));
        worst.along = std::max(worst.along, std::abs(ray.w.y - start.w.y));
    }
    return worst;
}

template <class Field>
f64::Ray rayFrom(const Field& field, const dvec3& x, const dvec3& direction) {
    return {x, glm::normalize(direction) * field.optics(x).n};
}

/// Bounds of an integrator in the fish-eye, where rays go round for ever, in some 90 steps of kStep each time.
struct Bounds {
    Method method;
    const char* name;
    int steps;
    double hamiltonian, bouguer;
    double wayBack;  ///< distance of the start from the ray that was followed back
};

// Leapfrog is symplectic: an error of h² in |w| - n that does not grow, and no kick or drift changes |x × w| about a centre;
// it is symmetric in time, so that rounding alone is left of the way back. The methods of fourth order err by less, and drift in
// proportion to the path. Euler's method has left the fish-eye after 1000 steps.
constexpr Bounds kBounds[] = {
    {Method::kEuler, "Euler", 100, 0.06, 0.04, 0.08},
    {Method::kLeapfrog, "leapfrog", 1000, 2e-5, 1e-13, 1e-12},
    {Method::kLeapfrog, "leapfrog, long", 100000, 2e-5, 1e-12, 1e-8},
    {Method::kRk4, "Runge-Kutta", 1000, 3e-9, 2e-9, 1e-7},
    {Method::kRk4, "Runge-Kutta, long", 100000, 1e-7, 1e-7, 1e-3},
    {Method::kSharma, "Sharma", 1000, 2e-8, 1e-9, 2e-4},
    {Method::kSharma, "Sharma, long", 100000, 4e-7, 1e-7, 1e-3},
};

TEST(StableIntegrators, InvariantsOverLongPaths) {
    const bench::FishEye eye;
    const f64::Ray start = rayFrom(eye, {0.6, 0.1, 0.0}, {0.2, 1.0, 0.3});
    for (const Bounds& bounds : kBounds) {
        SCOPED_TRACE(bounds.name);
        const Deviations worst = followed(eye, bounds.method, start, bounds.steps, kStep);
        EXPECT_LE(worst.hamiltonian, bounds.hamiltonian);
        EXPECT_LE(worst.bouguer, bounds.bouguer);
    }
}

TEST(StableIntegrators, TheWayBackLeadsToTheStart) {
    const bench::FishEye eye;
    const f64::Ray start = rayFrom(eye, {0.6, 0.1, 0.0}, {0.2, 1.0, 0.3});
    for (const Bounds& bounds : kBounds) {
        const f64::Ray there = followed(eye, bounds.method, start, bounds.steps, kStep).end;
        const f64::Ray back = followed(eye, bounds.method, {there.x, -there.w}, bounds.steps, kStep).end;
        // across the ray: steps of Sharma's method are of another length on the way back, which leaves 0.02 along a curved path
        EXPECT_LE(glm::length(glm::cross(back.x - start.x, glm::normalize(start.w))), bounds.wayBack) << bounds.name;
    }
}

TEST(StableIntegrators, LayersKeepTheWaveVectorAlongThem) {
    const bench::SechProfile layers;  // ∇n has no component along y: n sin θ stays to the bit but for rounding
    const f64::Ray start = rayFrom(layers, {0.0, 0.0, 0.0}, {0.6, 0.5, 1.0});
    for (const Bounds& bounds : kBounds) {
        EXPECT_LE(followed(layers, bounds.method, start, 100000, kStep).along, 1e-12) << bounds.name;
    }
}

TEST(StableIntegrators, WhisperingGalleryForThousandsOfReflections) {
    // Inside a ball of glass along its boundary, beyond the critical angle at every reflection: about 17 degrees of arc each.
    const double width = 0.02;
    const reference::SmoothedSphere ball(0.8, 1.5, width);
    const f64::Ray start = rayFrom(ball, {0.0, 0.7, 0.0}, {1.0, 0.0, 0.0});
    const Deviations leapfrog = followed(ball, Method::kLeapfrog, start, 200000, 0.5 * width);
    EXPECT_LE(leapfrog.bouguer, 1e-12);
    EXPECT_LE(leapfrog.hamiltonian, 6e-4);         // h² in the boundary, and it does not add up
    EXPECT_LE(glm::length(leapfrog.end.x), 0.85);  // still in the ball after 2000 units, some 2500 reflections
}

TEST(StableIntegrators, CriticalAngleFromBothSides) {
    // A plane boundary of the width that scenes have, in steps of 0.75 voxel, from glass: what is h² in |w| - n decides
    // about the last thousandths of a degree.
    const double voxel = 1.0 / 64.0, width = 1.5 * voxel;
    const auto plane = [width](const dvec3& x) {
        const double z = x.x / width;
        return reference::Optics{1.25 - 0.25 * std::erf(z / std::numbers::sqrt2),
                                 {-0.5 / (width * std::sqrt(2.0 * std::numbers::pi)) * std::exp(-0.5 * z * z), 0.0, 0.0}};
    };
    struct Plane {
        std::function<reference::Optics(const dvec3&)> at;
        reference::Optics optics(const dvec3& x) const { return at(x); }
    } const field{plane};
    const double critical = std::asin(1.0 / 1.5);
    for (const double degrees : {0.1, 0.01, 0.001}) {
        for (const double side : {-1.0, 1.0}) {
            const double angle = critical + glm::radians(side * degrees);
            f64::Ray ray = rayFrom(field, {-12.0 * width, 0.0, 0.0}, {std::cos(angle), std::sin(angle), 0.0});
            ray = followed(field, Method::kLeapfrog, ray, 4000, 0.75 * voxel).end;
            const bool passed = ray.x.x > 0.0;
            EXPECT_EQ(passed, side < 0.0) << degrees * side << " degrees from the critical angle";
            EXPECT_NEAR(ray.w.y, 1.5 * std::sin(angle), 1e-12);
            const double n = passed ? 1.0 : 1.5;
            EXPECT_NEAR(n * ray.w.y / glm::length(ray.w), 1.5 * std::sin(angle), 1e-4);
        }
    }
}

} // namespace
} // namespace eikonal

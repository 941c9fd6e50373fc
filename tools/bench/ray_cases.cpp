#include "tools/bench/ray_cases.h"

#include <numbers>

#include "tools/bench/follow_ray.h"
#include "tools/bench/index_profiles.h"

namespace eikonal::bench {

namespace {

/// The i-th of many points on a disc, evenly by radius, turned by the golden angle.
glm::dvec2 onDisc(int i, int count, double radius) {
    const double r = radius * (i + 0.5) / count, angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// Parallel rays from where they enter the lens to the far pole, where they all meet.
RayCase luneburgCase(int rays) {
    const Luneburg lens;
    RayCase result{"Luneburg lens", [lens](const glm::dvec3& x) { return lens.optics(x); }, {}, {}};
    for (int i = 0; i < rays; ++i) {
        const glm::dvec2 b = onDisc(i, rays, 0.95);
        const double depth = std::sqrt(1.0 - glm::dot(b, b));
        result.starts.push_back({{-depth, b.x, b.y}, {1.0, 0.0, 0.0}});
        // a quarter of the period: the wave vector there is minus the entry point; the optical path from the plane x = -1 is
        // 1 + π/2
        result.truth.push_back({{1.0, 0.0, 0.0}, {depth, -b.x, -b.y}, depth + 0.5 * std::numbers::pi});
    }
    return result;
}

RayCase gradedRodCase(int rays) {
    const GradedRod rod;
    RayCase result{"graded rod", [rod](const glm::dvec3& x) { return rod.optics(x); }, {}, {}};
    for (int i = 0; i < rays; ++i) {
        const glm::dvec2 start = onDisc(i, rays, 0.4);
        const double r2 = glm::dot(start, start), rate = rod.n0 * rod.g;
        const double wz = rod.n0 * std::sqrt(1.0 - rod.g * rod.g * r2);  // conserved
        const double tau = 2.0 * kHalfBox / wz, phase = rate * tau;
        const glm::dvec2 end = start * std::cos(phase), w = start * (-rate * std::sin(phase));
        const double squares = r2 * (0.5 * tau + std::sin(2.0 * phase) / (4.0 * rate));  // ∫ρ² dτ
        result.starts.push_back({{start.x, start.y, -kHalfBox}, {0.0, 0.0, 1.0}});
        result.truth.push_back({{end.x, end.y, kHalfBox}, glm::normalize(glm::dvec3(w.x, w.y, wz)),
                                rod.n0 * rod.n0 * (tau - rod.g * rod.g * squares)});
    }
    return result;
}

/// From the axis at an angle α in the plane: sinh(g x) = tan α sin(g z).
RayCase sechCase(int rays) {
    const SechProfile slab;
    RayCase result{"sech profile", [slab](const glm::dvec3& x) { return slab.optics(x); }, {}, {}};
    for (int i = 0; i < rays; ++i) {
        const double angle = glm::radians(40.0) * (2.0 * (i + 0.5) / rays - 1.0), y = 0.8 * onDisc(i, rays, 1.0).x;
        const double phase = slab.g * 2.0 * kHalfBox, rise = std::tan(angle);
        const double x = std::asinh(rise * std::sin(phase)) / slab.g;
        const double slope = rise * std::cos(phase) / std::cosh(slab.g * x);
        // n0/g times the angle whose tangent is tan(g z)/cos α, past the quarter periods that g z has passed
        const double turned = std::atan2(std::sin(phase) / std::cos(angle), std::cos(phase));
        result.starts.push_back({{0.0, y, -kHalfBox}, {std::sin(angle), 0.0, std::cos(angle)}});
        result.truth.push_back({{x, y, kHalfBox}, glm::normalize(glm::dvec3(slope, 0.0, 1.0)),
                                slab.n0 / slab.g * (turned < 0.0 ? turned + 2.0 * std::numbers::pi : turned)});
    }
    return result;
}

/// A great circle of the sphere that the fish-eye is the stereographic image of.
class FishEyeOrbit {
public:
    explicit FishEyeOrbit(const RayStart& start) {
        const double q = 1.0 + glm::dot(start.x, start.x), dq = 2.0 * glm::dot(start.x, start.direction);
        from_ = glm::dvec4(2.0 / q * start.x, (q - 2.0) / q);
        const glm::dvec4 along(2.0 / q * start.direction - start.x * (2.0 * dq / (q * q)), 2.0 * dq / (q * q));
        along_ = glm::normalize(along);
    }
    glm::dvec3 position(double angle) const {
        const glm::dvec4 p = std::cos(angle) * from_ + std::sin(angle) * along_;
        return glm::dvec3(p) / (1.0 - p.w);
    }
    glm::dvec3 direction(double angle) const {
        const glm::dvec4 p = std::cos(angle) * from_ + std::sin(angle) * along_;
        const glm::dvec4 dp = std::cos(angle) * along_ - std::sin(angle) * from_;
        return glm::normalize(glm::dvec3(dp) * (1.0 - p.w) + glm::dvec3(p) * dp.w);
    }
    /// Where it first leaves the box.
    double exitAngle() const {
        double inside = 0.0, outside = 0.0;
        while (isInside(outside)) {
            inside = outside;
            outside += 0.01;
        }
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (inside + outside);
            (isInside(middle) ? inside : outside) = middle;
        }
        return inside;
    }

private:
    bool isInside(double angle) const {
        const glm::dvec3 x = glm::abs(position(angle));
        return std::max({x.x, x.y, x.z}) <= kHalfBox * (1.0 + 1e-15);
    }
    glm::dvec4 from_, along_;
};

RayCase fishEyeCase(int rays) {
    const FishEye eye;
    RayCase result{"fish-eye", [eye](const glm::dvec3& x) { return eye.optics(x); }, {}, {}};
    for (int i = 0; i < rays; ++i) {
        const glm::dvec2 b = onDisc(i, rays, 0.9);
        const RayStart start{{-kHalfBox, b.x, b.y}, {1.0, 0.0, 0.0}};
        const FishEyeOrbit orbit(start);
        const double angle = orbit.exitAngle();
        result.starts.push_back(start);
        result.truth.push_back({orbit.position(angle), orbit.direction(angle), 0.5 * eye.n0 * angle});
    }
    return result;
}

RayCase sphereCase(int rays) {
    const double radius = 0.8, width = 0.04;
    const reference::SmoothedSphere sphere(radius, 1.5, width);
    RayCase result{"smoothed sphere", [sphere](const glm::dvec3& x) { return sphere.optics(x); }, {}, {}};
    for (int i = 0; i < rays; ++i) {
        const glm::dvec2 b = onDisc(i, rays, 0.95 * radius);
        const RayStart start{{-kHalfBox, b.x, b.y}, {1.0, 0.0, 0.0}};
        result.starts.push_back(start);
        result.truth.push_back(followRay(sphere, Method::kRk4, start, {width / 200.0, width / 200.0}).end);
    }
    return result;
}

} // namespace

std::vector<RayCase> rayCases(int rays) {
    return {luneburgCase(rays), fishEyeCase(rays), gradedRodCase(rays), sechCase(rays), sphereCase(rays)};
}

} // namespace eikonal::bench

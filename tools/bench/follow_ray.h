#pragma once
// A ray through the box of the cases by one of the integrators, in double precision. For .cpp files only (common/reference/stepper.h).

#include <algorithm>

#include "tools/bench/ray_cases.h"
#include "common/reference/stepper.h"

namespace eikonal::bench {

enum class Method { kEuler, kLeapfrog, kRk4, kSharma };

/// Arc length of steps [scene units]: that in which the index turns a ray by an angle, ε n/|∇n|, within bounds.
struct StepRule {
    double shortest, longest;
    double angle = 0.0;  ///< ε [rad]; 0: all are of the longest length

    bool adapts() const { return angle > 0.0; }
    double lengthAt(double n, const glm::dvec3& gradN) const {
        const double slope = glm::length(gradN);
        return slope * longest > angle * n ? std::max(angle * n / slope, shortest) : longest;
    }
};

struct FollowedRay {
    RayEnd end;
    std::uint64_t evaluations = 0;  ///< without those that find the length of the last step
};

template <class Field>
f64::RayStep takeStep(f64::Stepper<Field>& stepper, Method method, const f64::Ray& ray, double ds) {
    switch (method) {
        case Method::kEuler: return stepper.stepEuler(ray, ds);
        case Method::kLeapfrog: return stepper.stepLeapfrog(ray, ds);
        case Method::kRk4: return stepper.stepRk4(ray, ds);
        case Method::kSharma: break;
    }
    return stepper.stepSharma(ray, ds);
}

/// Signed distance along the ray to the face where it leaves.
inline double toFace(const f64::Ray& ray) {
    return f64::boxSpan(ray.x, glm::normalize(ray.w), glm::dvec3(-kHalfBox), glm::dvec3(kHalfBox)).leave;
}

/// The last step again, of the length that ends on the face, so that the error is the integrator's alone.
template <class Field>
f64::RayStep lastStep(f64::Stepper<Field>& stepper, Method method, const f64::Ray& ray) {
    double ds = std::max(toFace(ray), 0.0);
    f64::RayStep step = takeStep(stepper, method, ray, ds);
    for (int i = 0; i < 5; ++i) {
        ds += toFace(step.ray);
        step = takeStep(stepper, method, ray, ds);
    }
    return step;
}

/// A ray on its way.
template <class Field>
class Walk {
public:
    Walk(const Field& field, Method method, const StepRule& rule, const RayStart& start)
        : stepper_(field), method_(method), rule_(rule) {
        const reference::Optics here = field.optics(start.x);
        ray_ = {start.x, start.direction * here.n};
        next_ = rule.adapts() ? rule.lengthAt(here.n, here.gradN) : rule.longest;
    }

    /// One step; whether it stays inside.
    bool advance() {
        const std::uint64_t before = stepper_.evaluations();
        f64::RayStep step = fittingStep();
        evaluations_ += stepper_.evaluations() - before;
        const glm::dvec3 reach = glm::abs(step.ray.x);
        const bool leaves = std::max({reach.x, reach.y, reach.z}) > kHalfBox;
        if (leaves) step = lastStep(stepper_, method_, ray_);
        ray_ = step.ray;
        opticalLength_ += step.opticalLength;
        length_ += taken_;
        return !leaves;
    }

    double length() const { return length_; }
    FollowedRay end() const { return {{ray_.x, glm::normalize(ray_.w), opticalLength_}, evaluations_}; }

private:
    /// A step that finds itself more than twice too long is taken again, once; lengths grow at most twofold.
    f64::RayStep fittingStep() {
        taken_ = next_;
        f64::RayStep step = takeStep(stepper_, method_, ray_, taken_);
        if (!rule_.adapts()) return step;
        double wanted = rule_.lengthAt(step.n, step.gradN);
        if (taken_ > 2.0 * wanted) {
            taken_ = wanted;
            step = takeStep(stepper_, method_, ray_, taken_);
            wanted = rule_.lengthAt(step.n, step.gradN);
        }
        next_ = std::min(wanted, 2.0 * taken_);
        return step;
    }

    f64::Stepper<Field> stepper_;
    Method method_;
    StepRule rule_;
    f64::Ray ray_{};
    double next_ = 0.0, taken_ = 0.0, length_ = 0.0, opticalLength_ = 0.0;
    std::uint64_t evaluations_ = 0;
};

/// To where the ray leaves the box, or to where it has been caught for ten edges.
template <class Field>
FollowedRay followRay(const Field& field, Method method, const RayStart& start, const StepRule& rule) {
    Walk<Field> walk(field, method, rule, start);
    while (walk.advance() && walk.length() < 20.0 * kHalfBox) {
    }
    return walk.end();
}

} // namespace eikonal::bench

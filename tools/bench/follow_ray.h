#pragma once
// A ray through the box of the cases by one of the integrators, in double precision. For .cpp files only (stepper.h).

#include <algorithm>

#include "tools/bench/ray_cases.h"
#include "tools/bench/stepper.h"

namespace eikonal::bench {

enum class Method { kEuler, kLeapfrog, kRk4, kSharma };

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

/// Steps of `ds` [scene units of arc length] to where the ray leaves the box, or to where it has been caught for ten edges.
template <class Field>
FollowedRay followRay(const Field& field, Method method, const RayStart& start, double ds) {
    const int mostSteps = int(20.0 * kHalfBox / ds);
    f64::Stepper<Field> stepper(field);
    f64::Ray ray{start.x, start.direction * field.optics(start.x).n};
    double opticalLength = 0.0;
    std::uint64_t evaluations = 0;
    for (int i = 0; i < mostSteps; ++i) {
        f64::RayStep step = takeStep(stepper, method, ray, ds);
        const glm::dvec3 reach = glm::abs(step.ray.x);
        const bool leaves = std::max({reach.x, reach.y, reach.z}) > kHalfBox;
        if (i == 0) {
            evaluations = stepper.evaluations();
        }
        if (leaves) {
            step = lastStep(stepper, method, ray);
        }
        ray = step.ray;
        opticalLength += step.opticalLength;
        if (leaves) {
            return {{ray.x, glm::normalize(ray.w), opticalLength}, evaluations * std::uint64_t(i + 1)};
        }
    }
    return {{ray.x, glm::normalize(ray.w), opticalLength}, stepper.evaluations()};
}

} // namespace eikonal::bench

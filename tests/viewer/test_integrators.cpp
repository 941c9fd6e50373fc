// The kernel's integrators and ways to interpolate against the same steps in double precision, and the order of each.
#include <cmath>

#include "common/reference/stepper.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

using Step = f64::RayStep (f64::Stepper<reference::GridField>::*)(f64::Ray, double);

struct Method {
    const char* name;
    Integrator integrator;
    Step step;
    double order;
    std::uint32_t evaluations;  ///< of a step
};

using GridStepper = f64::Stepper<reference::GridField>;
const Method kMethods[] = {{"Euler", Integrator::kEuler, &GridStepper::stepEuler, 1.0, 1},
                           {"Leapfrog", Integrator::kLeapfrog, &GridStepper::stepLeapfrog, 2.0, 1},
                           {"Rk4", Integrator::kRk4, &GridStepper::stepRk4, 4.0, 4},
                           {"Sharma", Integrator::kSharma, &GridStepper::stepSharma, 4.0, 3}};

/// A soft lens, n = 1 + 0.4 exp(-r²/0.08), of which 4e-6 is left at the faces of the box.
Fields softLens(int resolution) {
    return test::indexFields(test::cube(resolution, 1.0),
                             [](const glm::dvec3& x) { return 1.0 + 0.4 * std::exp(-12.5 * glm::dot(x, x)); });
}

std::vector<TraceRay> raysThroughLens() {
    std::vector<TraceRay> rays;
    for (int i = 0; i < 60; ++i) {
        const double radius = 0.5 * std::sqrt((i + 0.5) / 60.0), angle = 2.399963229728653 * i;
        rays.push_back({{-1.0, radius * std::cos(angle), radius * std::sin(angle)}, {1.0, 0.1, -0.05}});
    }
    return rays;
}

std::vector<TraceResult> traced(const Fields& fields, Interpolation interpolation, Integrator integrator, double stepVoxels) {
    const Accuracy accuracy{.integrator = integrator, .interpolation = interpolation, .stepVoxels = stepVoxels};
    return traceRays(test::sharedContext(), fields, test::effectsOf(Scene{}, fields), accuracy, raysThroughLens(),
                     StraightFlights::kNone);
}

/// Directions behind the lens, by steps in double precision as many as keep inside the box; nothing bends rays near its faces.
std::vector<glm::dvec3> followed(const Fields& fields, Interpolation interpolation, Step step, double ds) {
    const reference::GridField field(fields, interpolation);
    GridStepper stepper(field);
    std::vector<glm::dvec3> directions;
    for (const TraceRay& start : raysThroughLens()) {
        f64::Ray ray{start.origin, glm::normalize(start.direction) * field.optics(start.origin).n};
        while (ray.x.x + ds < 1.0) ray = (stepper.*step)(ray, ds).ray;
        directions.push_back(glm::normalize(ray.w));
    }
    return directions;
}

double rmsApart(const std::vector<TraceResult>& results, const std::vector<glm::dvec3>& truth) {
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_EQ(results[i].status, TraceStatus::kExited);
        squares += glm::dot(results[i].direction - truth[i], results[i].direction - truth[i]);
    }
    return std::sqrt(squares / double(truth.size()));
}

class Integrators : public ::testing::TestWithParam<std::tuple<Method, Interpolation>> {
protected:
    Method method = std::get<0>(GetParam());
    Interpolation interpolation = std::get<1>(GetParam());
};

TEST_P(Integrators, GoWhereTheSameStepsGoInDoublePrecision) {
    const Fields fields = softLens(32);
    const auto results = traced(fields, interpolation, method.integrator, 1.0);
    // rounding of a wave vector of 1 at each of some 40 steps, and of the gradient that floats of n hold
    EXPECT_LE(rmsApart(results, followed(fields, interpolation, method.step, fields.lattice.voxel)), 5e-6);
    for (const TraceResult& end : results) {
        EXPECT_NEAR(end.position.x, 1.0, 1e-5);  // they leave by that face, and end on it
        EXPECT_EQ((end.evaluations - 1) % method.evaluations, 0u);  // one where they enter
    }
}

INSTANTIATE_TEST_SUITE_P(All, Integrators,
                         ::testing::Combine(::testing::ValuesIn(kMethods),
                                            ::testing::Values(Interpolation::kLinear, Interpolation::kCubic)),
                         [](const auto& row) {
                             return std::string(std::get<0>(row.param).name) +
                                    (std::get<1>(row.param) == Interpolation::kCubic ? "Cubic" : "Linear");
                         });

TEST(IntegratorOrder, IsObservedOnTheKernelsRays) {
    const Fields fields = softLens(96);
    const double voxel = fields.lattice.voxel;
    const auto truth = followed(fields, Interpolation::kCubic, &GridStepper::stepRk4, 0.125 * voxel);
    for (const Method& method : kMethods) {
        std::vector<double> errors;
        for (const double step : {16.0, 8.0, 4.0, 2.0})
            errors.push_back(rmsApart(traced(fields, Interpolation::kCubic, method.integrator, step), truth));
        // what floats keep is 6e-7: where the finest error is near it, the order is that of the steps before
        const std::size_t last = errors[3] > 2e-5 ? 3 : 2;
        const double observed = std::log2(errors[last - 2] / errors[last]) / 2.0;
        RecordProperty(method.name, std::to_string(observed));
        EXPECT_NEAR(observed, method.order, 0.5) << method.name;  // half: terms of the next order, in steps that long
    }
}

TEST(CubicInterpolation, LowersTheFloorOfVoxels) {
    const Fields fields = softLens(48);
    const auto truth = followed(softLens(192), Interpolation::kCubic, &GridStepper::stepRk4, 1.0 / 96.0);
    const double ofLinear = rmsApart(traced(fields, Interpolation::kLinear, Integrator::kRk4, 0.5), truth);
    const double ofCubic = rmsApart(traced(fields, Interpolation::kCubic, Integrator::kRk4, 0.5), truth);
    EXPECT_LT(10.0 * ofCubic, ofLinear);  // by h⁴ in place of h², with voxels of a fifth of the lens's width
}

} // namespace
} // namespace eikonal

#include "tools/bench/ray_bench.h"

#include <cmath>
#include <ctime>

#include <fmt/core.h>

#include "tools/bench/follow_ray.h"
#include "tools/bench/sampled_field.h"

namespace eikonal::bench {

namespace {

struct NamedMethod {
    const char* name;
    Method method;
    bool adapts;
};
constexpr std::array kMethods = {NamedMethod{"euler", Method::kEuler, false}, NamedMethod{"leapfrog", Method::kLeapfrog, false},
                                 NamedMethod{"rk4", Method::kRk4, false}, NamedMethod{"sharma", Method::kSharma, false},
                                 NamedMethod{"adaptive leapfrog", Method::kLeapfrog, true},
                                 NamedMethod{"adaptive rk4", Method::kRk4, true}};

/// A voxel of 128 along the edge [scene units]: the unit of steps, whatever the field's resolution.
constexpr double kReferenceVoxel = 2.0 * kHalfLattice / 128.0;

/// By which single precision misplaces n, and so what a voxel adds to a ray's direction [rad].
constexpr double kRounding = 0x1p-24;

/// What interpolation alone is estimated with: what its steps err by is far below.
constexpr NamedMethod kFine{"leapfrog", Method::kLeapfrog, false};
constexpr double kFineStepVoxels = 0.5;

/// Adaptive steps are within this factor of the fixed ones that share their row of the table, and of their length where n
/// changes by itself over this distance [scene units].
constexpr double kAdaptiveRange = 4.0, kAdaptiveLength = 0.5;

StepRule ruleOf(const NamedMethod& method, double ds) {
    if (!method.adapts) return {ds, ds};
    return {ds / kAdaptiveRange, ds * kAdaptiveRange, ds / kAdaptiveLength};
}

/// What interpolates the case's index, and on how many voxels; 0: nothing does.
struct FieldKind {
    const char* name;
    int resolution;
    Line line;
    double fieldError = 0.0;  ///< of the exit direction [rad], estimated without the truth
};

/// The case's own closed form, with the interface of the other fields.
struct ClosedForm {
    const RayCase& rayCase;
    reference::Optics optics(const glm::dvec3& x) const { return rayCase.optics(x); }
};

/// Root mean squares over the rays: direction [rad], position [voxels of the 128 along the edge], optical path, relative.
std::vector<double> errorsOf(const std::vector<RayEnd>& ends, const std::vector<RayEnd>& truth) {
    glm::dvec3 squares(0.0);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const glm::dvec3 error(glm::distance(ends[i].direction, truth[i].direction),
                               glm::distance(ends[i].x, truth[i].x) / kReferenceVoxel,
                               ends[i].opticalLength / truth[i].opticalLength - 1.0);
        squares += error * error;
    }
    const glm::dvec3 rms = glm::sqrt(squares / double(ends.size()));
    return {rms.x, rms.y, rms.z};
}

double rmsApart(const std::vector<RayEnd>& a, const std::vector<RayEnd>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec3 apart = a[i].direction - b[i].direction;
        squares += glm::dot(apart, apart);
    }
    return std::sqrt(squares / double(a.size()));
}

/// What halving the step takes off an error is this share of it.
double shareLostByHalving(Method method) {
    const double order = method == Method::kEuler ? 1.0 : method == Method::kLeapfrog ? 2.0 : 4.0;
    return 1.0 - std::exp2(-order);
}

std::string settingOf(const FieldKind& kind, const StepRule& rule, double stepVoxels) {
    if (rule.adapts()) return fmt::format("turns of {:.2g} rad", rule.angle);
    return kind.resolution > 0 ? fmt::format("step {:g} voxels", stepVoxels * kind.resolution / 128.0)
                               : fmt::format("step {:g}/128 of the edge", stepVoxels);
}

struct Measured {
    Measurement row;
    std::vector<RayEnd> ends;
};

template <class Field>
Measured measure(const Field& field, const FieldKind& kind, const RayCase& rayCase, const NamedMethod& method,
                 double stepVoxels) {
    std::vector<RayEnd> ends;
    std::uint64_t evaluations = 0;
    const StepRule rule = ruleOf(method, stepVoxels * kReferenceVoxel);
    const std::clock_t start = std::clock();  // of the processor: other work does not count
    for (const RayStart& ray : rayCase.starts) {
        const FollowedRay followed = followRay(field, method.method, ray, rule);
        ends.push_back(followed.end);
        evaluations += followed.evaluations;
    }
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    const double rays = double(ends.size());
    return {{rayCase.name, kind.name, kind.resolution, method.name, settingOf(kind, rule, stepVoxels),
             double(evaluations) / rays, seconds / rays, errorsOf(ends, rayCase.truth), kind.line},
            ends};
}

/// Each row but the last is estimated by the one after it, which has half its step.
template <class Field>
void addCurves(Family& family, const Field& field, const FieldKind& kind, const RayCase& rayCase,
               const RayBenchOptions& options) {
    for (const NamedMethod& method : kMethods) {
        double stepVoxels = options.longestStepVoxels;
        std::vector<RayEnd> before;
        for (int i = 0; i < options.steps; ++i, stepVoxels *= 0.5) {
            Measured measured = measure(field, kind, rayCase, method, stepVoxels);
            if (i > 0) {
                const double ofStep = rmsApart(before, measured.ends) / shareLostByHalving(method.method);
                family.rows.back().estimate = std::hypot(ofStep, kind.fieldError);
            }
            before = std::move(measured.ends);
            family.rows.push_back(std::move(measured.row));
        }
    }
}

void addVoxelFields(Family& family, const RayCase& rayCase, int resolution, Line line, const RayBenchOptions& options) {
    const Fields fields =
        sampledField(cubeLattice(resolution, kHalfLattice), [&](const glm::dvec3& x) { return rayCase.optics(x).n; });
    const reference::GridField linear(fields, Interpolation::kLinear), cubic(fields, Interpolation::kCubic);
    const auto endsIn = [&](const reference::GridField& field) {
        return measure(field, {"", resolution, Line::kNone}, rayCase, kFine, kFineStepVoxels).ends;
    };
    const double ofLinear = rmsApart(endsIn(linear), endsIn(cubic));
    const double ofRounding = kRounding * std::sqrt(double(resolution));  // a random walk, voxel by voxel
    addCurves(family, linear, {"linear", resolution, line, ofLinear}, rayCase, options);
    addCurves(family, cubic, {"cubic", resolution, Line::kNone, ofRounding}, rayCase, options);
}

} // namespace

Family benchRays(const RayBenchOptions& options) {
    Family family{"rays",
                  "Rays: integrators on closed forms and on voxels",
                  "field evaluations per ray",
                  {{"direction_rad", "RMS error of the exit direction [rad]"},
                   {"position_voxels", "RMS error of the exit position [voxels of 128]"},
                   {"optical_path", "RMS error of the optical path, relative"}},
                  1e-8,
                  {}};
    for (const RayCase& rayCase : rayCases(options.rays)) {
        addCurves(family, ClosedForm{rayCase}, {"closed form", 0, Line::kDashed}, rayCase, options);
        for (const int resolution : options.resolutions) {
            const Line line = resolution == options.drawnResolution ? Line::kSolid : Line::kNone;
            addVoxelFields(family, rayCase, resolution, line, options);
        }
    }
    return family;
}

} // namespace eikonal::bench

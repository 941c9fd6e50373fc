#include "tools/bench/ray_bench.h"

#include <ctime>

#include <fmt/core.h>

#include "common/cubic_spline.h"
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

std::string settingOf(const FieldKind& kind, const StepRule& rule, double stepVoxels) {
    if (rule.adapts()) return fmt::format("turns of {:.2g} rad", rule.angle);
    return kind.resolution > 0 ? fmt::format("step {:g} voxels", stepVoxels * kind.resolution / 128.0)
                               : fmt::format("step {:g}/128 of the edge", stepVoxels);
}

template <class Field>
Measurement measure(const Field& field, const FieldKind& kind, const RayCase& rayCase, const NamedMethod& method,
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
    return {rayCase.name, kind.name, kind.resolution, method.name, settingOf(kind, rule, stepVoxels),
            double(evaluations) / rays, seconds / rays, errorsOf(ends, rayCase.truth), kind.line};
}

template <class Field>
void addCurves(Family& family, const Field& field, const FieldKind& kind, const RayCase& rayCase,
               const RayBenchOptions& options) {
    for (const NamedMethod& method : kMethods) {
        double stepVoxels = options.longestStepVoxels;
        for (int i = 0; i < options.steps; ++i, stepVoxels *= 0.5) {
            family.rows.push_back(measure(field, kind, rayCase, method, stepVoxels));
        }
    }
}

void addVoxelFields(Family& family, const RayCase& rayCase, int resolution, Line line, const RayBenchOptions& options) {
    Fields fields =
        sampledField(cubeLattice(resolution, kHalfLattice), [&](const glm::dvec3& x) { return rayCase.optics(x).n; });
    addCurves(family, reference::GridField(fields), {"linear", resolution, line}, rayCase, options);
    fields.iorSpline = splineCoefficients(fields.ior);
    addCurves(family, reference::GridField(fields), {"cubic", resolution, Line::kNone}, rayCase, options);
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

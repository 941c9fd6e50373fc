#include "tools/bench/irradiance_bench.h"

#include <algorithm>

#include <fmt/core.h>

#include "common/accuracy.h"
#include "lightsim/error_estimate.h"
#include "tools/bench/irradiance_cases.h"
#include "tools/bench/least_error.h"

namespace eikonal::bench {

namespace {

struct NamedDeposit {
    const char* name;
    Deposit deposit;
    bool isEstimated;
};
// What peak errs by has no estimate; what cells do is what auto does.
constexpr std::array kDeposits = {NamedDeposit{kPeakName, Deposit::kPeak, false}, NamedDeposit{"splat", Deposit::kSplat, true},
                                  NamedDeposit{"cells", Deposit::kCells, false}, NamedDeposit{kAutoName, Deposit::kAuto, true}};

/// Σ|E - E*|/ΣE* and |ΣE/ΣE* - 1| over the voxels that have a truth.
std::vector<double> errorsOf(const DenseGrid<glm::vec3>& irradiance, const DenseGrid<double>& truth) {
    double apart = 0.0, sum = 0.0, total = 0.0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (truth.values[i] > 0.0) {
            apart += std::abs(double(irradiance.values[i].x) - truth.values[i]);
            sum += double(irradiance.values[i].x);
            total += truth.values[i];
        }
    }
    return {apart / total, std::abs(sum / total - 1.0)};
}

/// One method on one case.
class Bench {
public:
    Bench(const gpu::Context& context, const IrradianceCase& lit, const NamedDeposit& method)
        : context_(context), lit_(lit), method_(method) {
        scene_.lights = {lit.light};
        scene_.accuracy.deposit = method.deposit;
        effects_ = decideEffects(scene_, lit.fields);
    }

    BakeResult bake(double tolerance) {
        scene_.accuracy.tolerance = tolerance;
        return bakeScene(context_, scene_, lit_.fields, effects_, {});
    }

    Measurement measure(double tolerance, Line line) {
        const BakeResult result = bake(tolerance);
        const BakeSeconds& seconds = result.statistics.seconds;
        return {lit_.name,
                std::string(interpolationName(result.statistics.interpolation)),
                lit_.fields.lattice.size.x,
                method_.name,
                fmt::format("tolerance {:g}", tolerance),
                double(result.statistics.patches.fieldEvaluations),
                seconds.propagate + seconds.read,
                errorsOf(result.light.irradiance, lit_.truth),
                line,
                estimated(result.light)};
    }

private:
    /// Over the voxels that have a truth.
    std::optional<double> estimated(const BakedLight& light) const {
        if (!method_.isEstimated) {
            return std::nullopt;
        }
        BakeErrorEstimator estimator(context_, scene_, lit_.fields, effects_, {});
        return estimator
            .estimate(lightsAt(lightsOf(scene_, effects_), 0.0), light,
                      [&](std::size_t voxel) { return lit_.truth.values[voxel] > 0.0; })
            .total;
    }

    const gpu::Context& context_;
    const IrradianceCase& lit_;
    NamedDeposit method_;
    Scene scene_;
    EffectSet effects_;
};

} // namespace

Family benchIrradiance(const gpu::Context& context, const IrradianceBenchOptions& options) {
    Family family{"irradiance",
                  "Irradiance: methods of the light simulator on voxels",
                  "field evaluations",
                  {{"relative_l1", "Σ|E − E*| / ΣE*"}, {"energy", "|ΣE / ΣE* − 1|"}},
                  1e-5,
                  {}};
    for (const int resolution : options.resolutions) {
        const Line line = resolution == options.resolutions.back() ? Line::kSolid : Line::kDashed;
        for (const IrradianceCase& lit : irradianceCases(resolution)) {
            for (const NamedDeposit& method : kDeposits) {
                Bench bench(context, lit, method);
                bench.bake(options.tolerances.front());  // the driver compiles the kernels
                for (const double tolerance : options.tolerances) {
                    family.rows.push_back(bench.measure(tolerance, line));
                }
            }
        }
    }
    family.notes = comparedWithPeak(family);
    return family;
}

} // namespace eikonal::bench

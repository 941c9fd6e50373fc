#include "tools/bench/irradiance_bench.h"

#include <algorithm>

#include <fmt/core.h>

#include "lightsim/bake.h"
#include "tools/bench/irradiance_cases.h"

namespace eikonal::bench {

namespace {

struct NamedDeposit {
    const char* name;
    Deposit deposit;
};
constexpr std::array kDeposits = {NamedDeposit{"peak (2007)", Deposit::kPeak}, NamedDeposit{"splat", Deposit::kSplat},
                                  NamedDeposit{"cells", Deposit::kCells}, NamedDeposit{"auto", Deposit::kAuto}};

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

Measurement measure(const gpu::Context& context, const IrradianceCase& lit, const NamedDeposit& method, double tolerance,
                    Line line) {
    Scene scene;
    scene.lights = {lit.light};
    scene.accuracy.deposit = method.deposit;
    scene.accuracy.tolerance = tolerance;
    const BakeResult result = bakeScene(context, scene, lit.fields, decideEffects(scene, lit.fields), {});
    const BakeSeconds& seconds = result.statistics.seconds;
    return {lit.name,
            "linear",
            lit.fields.lattice.size.x,
            method.name,
            fmt::format("tolerance {:g}", tolerance),
            double(result.statistics.patches.fieldEvaluations),
            seconds.propagate + seconds.read,
            errorsOf(result.light.irradiance, lit.truth),
            line};
}

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
                measure(context, lit, method, options.tolerances.front(), line);  // the driver compiles the kernels
                for (const double tolerance : options.tolerances) {
                    family.rows.push_back(measure(context, lit, method, tolerance, line));
                }
            }
        }
    }
    return family;
}

} // namespace eikonal::bench

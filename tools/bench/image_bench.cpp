#include "tools/bench/image_bench.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "common/physics.h"
#include "lightsim/bake.h"
#include "tools/bench/image_case.h"
#include "tools/bench/ssim.h"
#include "viewer/error_estimate.h"
#include "viewer/render.h"

namespace eikonal::bench {

namespace {

constexpr double kFineStepVoxels = 0.125;  // where the step is not what is looked at
constexpr int kSamplesPerEdge = 6;

/// Luminances as a display shows them, of a picture as wide as high.
GreyImage greyOf(const Radiances& radiances) {
    const int edge = int(std::lround(std::sqrt(double(radiances.size()))));
    GreyImage grey{edge, edge, {}};
    for (const glm::dvec3& radiance : radiances) {
        const double luminance = glm::dot(radiance, glm::dvec3(0.2126, 0.7152, 0.0722));
        grey.values.push_back(f64::srgbEncoded(luminance));
    }
    return grey;
}

/// RMS over pixels and bands and the largest difference, relative to the mean of the truth; and how different they look.
std::vector<double> errorsOf(const RenderResult& image, const Radiances& truth) {
    Radiances found;
    double squares = 0.0, sum = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const int x = int(i) % image.size.x, y = int(i) / image.size.x;
        found.emplace_back(image.radiance(x, y));
        const glm::dvec3 difference = glm::abs(found.back() - truth[i]);
        squares += glm::dot(difference, difference);
        sum += truth[i].x + truth[i].y + truth[i].z;
        largest = std::max({largest, difference.x, difference.y, difference.z});
    }
    const double values = 3.0 * double(truth.size()), mean = sum / values;
    return {std::sqrt(squares / values) / mean, largest / mean, structuralDissimilarity(greyOf(found), greyOf(truth))};
}

Scene sceneOf(const ImageCase& seen, double stepVoxels, int samples) {
    Scene scene = seen.scene;
    scene.accuracy.stepVoxels = stepVoxels;
    scene.render.samples = samples;
    return scene;
}

RenderResult rendered(const gpu::Context& context, const ImageCase& seen, const BakedLight& light, double stepVoxels,
                      int samples) {
    const Scene scene = sceneOf(seen, stepVoxels, samples);
    return renderScene(context, scene, seen.fields, decideEffects(scene, seen.fields), &light);
}

ErrorEstimate estimated(const gpu::Context& context, const ImageCase& seen, double stepVoxels, int samples) {
    const Scene scene = sceneOf(seen, stepVoxels, samples);
    return estimateError(context, scene, seen.fields, decideEffects(scene, seen.fields), &seen.light);
}

Measurement measured(const ImageCase& seen, const char* panel, const char* method, const std::string& setting,
                     const RenderResult& image, const Radiances& truth) {
    const auto& seconds = image.statistics.seconds;
    const auto found = std::find_if(seconds.begin(), seconds.end(), [](const auto& row) { return row.first == "image"; });
    return {panel, "linear", seen.fields.lattice.size.x, method, setting, double(image.statistics.fieldEvaluations),
            found->second, errorsOf(image, truth), Line::kSolid};
}

void addSteps(Family& family, const gpu::Context& context, const ImageCase& seen, const std::vector<double>& steps) {
    const Radiances truth = referenceImage(seen, 1);
    for (const double step : steps) {
        rendered(context, seen, seen.light, step, 1);  // the driver compiles what long steps need
        family.rows.push_back(measured(seen, "step", "leapfrog", fmt::format("step {:g} voxels", step),
                                       rendered(context, seen, seen.light, step, 1), truth));
        // the truth has the same voxels, and one ray through each pixel's centre
        family.rows.back().estimate = estimated(context, seen, step, 1).step;
    }
}

void addSamples(Family& family, const gpu::Context& context, const ImageCase& seen, const std::vector<int>& samples) {
    const Radiances truth = referenceImage(seen, kSamplesPerEdge);
    for (const int count : samples) {
        family.rows.push_back(measured(seen, "samples of a pixel", "samples", fmt::format("{} samples", count),
                                       rendered(context, seen, seen.light, kFineStepVoxels, count), truth));
        const ErrorEstimate estimate = estimated(context, seen, kFineStepVoxels, count);
        family.rows.back().estimate = std::hypot(estimate.step, estimate.sampling);
    }
}

/// The work is that of the bake.
void addTolerances(Family& family, const gpu::Context& context, const ImageCase& seen, const std::vector<double>& tolerances) {
    const Radiances truth = referenceImage(seen, 1);
    for (const double tolerance : tolerances) {
        Scene scene = seen.scene;
        scene.accuracy.tolerance = tolerance;
        const BakeResult bake = bakeScene(context, scene, seen.fields, decideEffects(scene, seen.fields), {});
        Measurement row = measured(seen, "tolerance of the bake", "tubes", fmt::format("tolerance {:g}", tolerance),
                                   rendered(context, seen, bake.light, kFineStepVoxels, 1), truth);
        row.evaluations = double(bake.statistics.patches.fieldEvaluations);
        row.seconds = bake.statistics.seconds.propagate + bake.statistics.seconds.read;
        family.rows.push_back(row);
    }
}

} // namespace

Family benchImage(const gpu::Context& context, const ImageBenchOptions& options) {
    Family family{"image",
                  "Image: a glass sphere in smoke against a reference in double precision",
                  "field evaluations",
                  {{"rms", "RMS error, relative to the mean"},
                   {"largest", "largest error, relative to the mean"},
                   {"dissimilarity", "1 − SSIM"}},
                  1e-6,
                  {}};
    const ImageCase seen = imageCase(options.pixels, options.resolution);
    addSteps(family, context, seen, options.stepsVoxels);
    addSamples(family, context, seen, options.samples);
    addTolerances(family, context, seen, options.tolerances);
    return family;
}

} // namespace eikonal::bench

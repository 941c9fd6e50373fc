#include "tools/bench/march_rates.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/accuracy.h"
#include "common/device_frame.h"
#include "common/error.h"
#include "common/gpu_fields.h"
#include "viewer/clearance.h"
#include "viewer/generate.h"
#include "viewer/portions.h"
#include "viewer/march.h"
#include "viewer/render.h"
#include "viewer/sampling.h"
#include "viewer/view.h"

namespace eikonal::bench {

namespace {

template <class Work>
double secondsOf(const Work& work) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    work();
    glFinish();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

EffectSet refractionOnly(EffectSet effects) {
    for (EffectDecision& decision : effects.decisions) decision.on = decision.on && decision.effect == Effect::kRefraction;
    return effects;
}

/// The camera's rays, and the kernels that work on them.
class Course {
public:
    Course(const gpu::Context& context, const Scene& scene, const Fields& fields)
        : effects_(refractionOnly(decideEffects(scene, fields))),
          fields_(context, fields, effects_, interpolationOfImages(scene.accuracy)),
          clearance_(context, fields, effects_, {.tolerance = scene.accuracy.tolerance}),
          batch_(context, std::size_t(scene.render.size.x) * std::size_t(scene.render.size.y)),
          generate_(context, fields_.defines(), viewer::Generate::Source::kPinhole),
          stepping_(context, fields_.defines(), {stepVoxelsOf(scene.accuracy)}, fields.lattice),
          flying_(context, withFlights(), {stepVoxelsOf(scene.accuracy)}, fields.lattice),
          fetching_(context, "bench/dependent_fetch.comp.glsl", fields_.defines()),
          fetchesPerRay_(gpu::uint(std::ceil(glm::length(glm::dvec3(fields.lattice.size)) / std::sqrt(3.0) /
                                             stepVoxelsOf(scene.accuracy)))) {
        viewer::configureCamera(batch_.view, deviceFromWorld(fields.lattice, scene.camera), scene.render.size);
        viewer::configureTile(batch_.view, {{0, 0}, scene.render.size}, 0);
        viewer::configureRound(batch_.view, 0, {});
        clearance_.configure(batch_.view);
    }

    Rate march(viewer::March& kernel) {
        start(kernel);
        Rate rate;
        rate.seconds = secondsOf([&] { kernel.run(batch_); });
        for (const gpu::RayState& ray : batch_.rays.download<gpu::RayState>(batch_.view.rayCount))
            if (ray.evaluations > 0) rate.count += ray.evaluations - 1.0 + ray.lookUps;
        return rate;
    }

    Rate fetch() {
        start(stepping_);
        batch_.view.stepsPerSlice = fetchesPerRay_;
        batch_.bind();
        batch_.lists.swap();
        Rate rate;
        rate.seconds = secondsOf([&] { batch_.lists.dispatch(fetching_); });
        rate.count = entered() * fetchesPerRay_;
        return rate;
    }

    double entered() const {
        const auto states = batch_.rays.download<gpu::RayState>(batch_.view.rayCount);
        return double(std::count_if(states.begin(), states.end(), [](const auto& ray) { return ray.evaluations > 0; }));
    }

    viewer::March& stepping() { return stepping_; }
    viewer::March& flying() { return flying_; }

private:
    std::vector<std::string> withFlights() const {
        auto defines = fields_.defines();
        for (const std::string& define : clearance_.defines()) defines.push_back(define);
        return defines;
    }
    void start(const viewer::March& kernel) {
        kernel.configure(batch_.view);
        fields_.bind();
        clearance_.bind();
        batch_.bind();
        generate_.run(batch_);
    }

    EffectSet effects_;
    GpuFields fields_;
    viewer::Clearance clearance_;
    viewer::RayBatch batch_;
    viewer::Generate generate_;
    viewer::March stepping_, flying_;
    gpu::Kernel fetching_;
    gpu::uint fetchesPerRay_;
};

/// A picture of the scene, and what a round of its samples takes.
class Picture {
public:
    Picture(const gpu::Context& context, const Scene& scene, const Fields& fields)
        : settings_(scene.render),
          image_(context, scene, fields, refractionOnly(decideEffects(scene, fields)), nullptr, optionsFor(context, scene)) {}

    Rate make() {
        const viewer::RayCounts before = image_.counts();
        Rate rate;
        rate.seconds = secondsOf([&] { renderFrame(image_, settings_, {}, false); }) / image_.rounds();
        const viewer::RayCounts after = image_.counts();
        rate.count = double(after.evaluations + after.lookUps - after.entered - before.evaluations - before.lookUps +
                            before.entered) /
                     image_.rounds();
        return rate;
    }

private:
    static RenderOptions optionsFor(const gpu::Context& context, const Scene& scene) {
        RenderOptions options;
        options.channels = false;
        options.tileRays = viewer::tilesOf(scene.render.size, viewer::raysAtATime(0, context.limits())).front().pixels();
        return options;
    }

    RenderSettings settings_;
    ProgressiveImage image_;
};

void keepShorter(Rate& best, const Rate& rate) {
    if (best.seconds == 0.0 || rate.seconds < best.seconds) best = rate;
}

} // namespace

MarchRates measureMarchRates(const gpu::Context& context, const Scene& scene, const Fields& fields, int repeats) {
    if (fields.iorGradient.empty())
        throw badInput(scene.source + ": expected an index that varies, found the same everywhere");
    Course course(context, scene, fields);
    Picture picture(context, scene, fields);
    MarchRates rates;
    for (int i = 0; i < repeats; ++i) {
        keepShorter(rates.fetches, course.fetch());
        keepShorter(rates.stepping, course.march(course.stepping()));
        keepShorter(rates.flying, course.march(course.flying()));
        keepShorter(rates.image, picture.make());
    }
    rates.rays = course.entered();
    context.throwIfError();
    return rates;
}

} // namespace eikonal::bench

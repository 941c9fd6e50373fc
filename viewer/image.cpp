#include "viewer/image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "common/accuracy.h"
#include "common/device_frame.h"
#include "common/environment_map.h"
#include "common/spectral_fields.h"

namespace eikonal {

namespace {

template <class Row>
void append(std::vector<Row>& rows, const std::vector<Row>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

viewer::EnvironmentLight surroundings(const gpu::Context& context, const Scene& scene, const EffectSet& effects,
                                      const BakedLight* bake) {
    const auto map = effects.has(Effect::kEnvironment) ? environmentImage(scene) : std::nullopt;
    // An environment that lights the bake is in its irradiance already.
    const bool ambient =
        effects.has(Effect::kOpaque) && effects.has(Effect::kEnvironment) && !(bake && scene.environment.bake);
    return {context, scene.environment, map ? &*map : nullptr, ambient, effects.has(Effect::kRoughness)};
}

std::optional<viewer::Clearance> clearanceFor(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                              const EffectSet& effects, const BakedLight* bake,
                                              const RenderOptions& options) {
    if (!options.straightFlights) return std::nullopt;
    return viewer::Clearance(context, fields, effects,
                             {.tolerance = scene.accuracy.tolerance, .lit = bake != nullptr});
}

void placeLight(gpu::ViewBlock& view, const BakedLight& bake, const Lattice& domain) {
    view.lightMin = glm::vec3(deviceFromWorld(domain, bake.lattice.min));
}

std::optional<viewer::Reflections> reflectionsFor(const gpu::Context& context, const Scene& scene,
                                                  const EffectSet& effects, const GpuFields& fields,
                                                  const RenderOptions& options) {
    if (!viewer::Reflections::areNeeded(effects, scene.accuracy.reflections)) return std::nullopt;
    return viewer::Reflections(context, fields.defines(), {scene.accuracy.reflections, scene.accuracy.tolerance},
                               options.tileRays);
}

bool hasGreyMatter(const Fields& fields) {
    return isGrey(fields.sigmaA) && isGrey(fields.sigmaS) && isGrey(fields.albedo) &&
           std::all_of(fields.insets.begin(), fields.insets.end(), [](const Inset& inset) { return isGrey(inset); });
}

RenderOptions withTile(RenderOptions options, const gpu::DeviceLimits& limits) {
    options.tileRays = viewer::raysAtATime(options.tileRays, limits);
    return options;
}

viewer::Generate generateFor(const gpu::Context& context, const GpuFields& fields,
                             const std::optional<viewer::Clearance>& clearance, const viewer::Sampling& sampling) {
    using Source = viewer::Generate::Source;
    auto defines = fields.defines();
    if (clearance) append(defines, clearance->defines());
    return {context, std::move(defines), sampling.hasLens() ? Source::kLens : Source::kPinhole};
}

/// How many samples the bands of wavelengths are divided into; 0 where noise decides how many there are.
int strataOf(const RenderSettings& render) { return render.noise > 0.0 ? 0 : render.samples; }

} // namespace

ProgressiveImage::ProgressiveImage(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                   const EffectSet& effects, const BakedLight* bake, const RenderOptions& options)
    : context_(context), options_(withTile(options, context.limits())), lattice_(fields.lattice), render_(scene.render),
      camera_(scene.camera), sampling_(viewer::samplingOf(scene.render, scene.camera)),
      fields_(context, fields, effects, interpolationOfImages(scene.accuracy)),
      environment_(surroundings(context, scene, effects, bake)),
      passes_(spectralBandsOf(scene.accuracy, effects), strataOf(scene.render)), hasGreyMatter_(hasGreyMatter(fields)),
      light_(context, bake, passes_.bandCount()),
      clearance_(clearanceFor(context, scene, fields, effects, bake, options_)),
      reflections_(reflectionsFor(context, scene, effects, fields_, options_)),
      batch_(context, options_.tileRays),
      generate_(generateFor(context, fields_, clearance_, sampling_)), steps_(stepVoxelsOf(scene.accuracy), 1.0),
      integrator_(integratorOf(scene.accuracy)), shade_(context, allDefines()), accumulate_(context, fields_.defines()),
      toneMap_(context, scene.render.toneMap), painter_(context, allDefines(), scene.render.toneMap) {
    gpu::ViewBlock& view = batch_.view;
    view.opaqueOffset = float(lattice_.voxel);
    view.minThroughput = float(options.minThroughput);
    view.sampleShare = 1.0f / float(std::max(scene.render.samples, 1));
    environment_.configure(view);
    configureLight();
    if (bake) placeLight(view, *bake, lattice_);
    if (clearance_) clearance_->configure(view);
    if (reflections_) reflections_->configure(view);
    march().configure(view);
    setExposure(scene.render.exposureEv);
}

std::vector<std::string> ProgressiveImage::allDefines() const {
    std::vector<std::string> defines = fields_.defines();
    append(defines, environment_.defines());
    append(defines, light_.defines());
    if (clearance_) append(defines, clearance_->defines());
    if (reflections_) append(defines, reflections_->defines());
    return defines;
}

viewer::March& ProgressiveImage::march() {
    auto found = marches_.find(steps_);
    if (found == marches_.end()) {
        const auto [step, matter] = steps_;
        const viewer::MarchSettings settings{step, matter, integrator_, options_.maxEvaluations, options_.stepsPerSlice,
                                             fields_.insetBounds()};
        found = marches_.emplace(steps_, viewer::March(context_, allDefines(), settings, lattice_)).first;
    }
    return found->second;
}

void ProgressiveImage::configureLight() {
    light_.configure(batch_.view);
    passes_.configure(batch_.view, light_.isByBand() && !hasGreyMatter_);
}

void ProgressiveImage::startOver() {
    round_ = 0;
    pixelsDone_ = 0;
    isQuiet_ = false;
}

void ProgressiveImage::setFrame(const glm::ivec2& size, const viewer::Tile& region) {
    region_ = region;
    viewer::configureCamera(batch_.view, deviceFromWorld(lattice_, camera_), size);
    accumulate_.reserve(context_, region.pixels());
    toneMap_.reserve(context_, region.pixels());
    startOver();
}

void ProgressiveImage::setCamera(const Camera& camera) {
    camera_ = camera;
    const bool hadLens = sampling_.hasLens();
    sampling_ = viewer::samplingOf(render_, camera);
    if (sampling_.hasLens() != hadLens) generate_ = generateFor(context_, fields_, clearance_, sampling_);
    viewer::configureCamera(batch_.view, deviceFromWorld(lattice_, camera), batch_.view.imageSize);
    startOver();
}

void ProgressiveImage::setLight(const BakedLight& bake) {
    assert(!light_.defines().empty());
    light_ = viewer::Light(context_, &bake, passes_.bandCount());
    configureLight();
    placeLight(batch_.view, bake, lattice_);
    startOver();
}

void ProgressiveImage::moveInsets(const Fields& fields) {
    fields_.moveInsets(fields);
    if (clearance_) {
        clearance_->move(fields);
        clearance_->configure(batch_.view);
    }
    for (auto& [steps, march] : marches_) march.setInsets(fields_.insetBounds());
    march().configure(batch_.view);
    startOver();
}

void ProgressiveImage::setStep(double stepVoxels, double matterVoxels) {
    steps_ = {stepVoxels, matterVoxels};
    march().configure(batch_.view);
    startOver();
}

void ProgressiveImage::setExposure(double ev) { batch_.view.exposureScale = float(std::exp2(ev)); }

void ProgressiveImage::bind() {
    fields_.bind();
    light_.bind();
    environment_.bind();
    if (clearance_) clearance_->bind();
    if (reflections_) reflections_->bind();
    accumulate_.bind();
    batch_.bind();
}

void ProgressiveImage::mark(std::string_view pass) const {
    if (timer_) timer_->mark(pass);
}

void ProgressiveImage::runPass(std::size_t pass) {
    passes_.begin(pass, viewer::sampleOfRound(round_, sampling_), batch_.view, fields_, light_);
    batch_.bind();
    mark("generate");
    generate_.run(batch_);
    mark("march");
    march().run(batch_);
    if (reflections_) {
        mark("reflections");
        reflections_->run(batch_, march(), shade_);
    }
    mark("shade");
    shade_.run(batch_);
    mark("accumulate");
    accumulate_.run(batch_);
}

std::size_t ProgressiveImage::addRays(std::size_t most) {
    const std::size_t count = std::clamp<std::size_t>(most, 1, options_.tileRays);
    const viewer::Tile tile = viewer::nextTile(region_, pixelsDone_, count);
    viewer::configureTile(batch_.view, tile, pixelsDone_);
    viewer::configureRound(batch_.view, round_, sampling_);
    batch_.view.subPixel = 0.5f + options_.pixelShare * (batch_.view.subPixel - 0.5f);
    bind();
    for (std::size_t pass = 0; pass < passes_.count(); ++pass) {
        runPass(pass);
    }
    mark({});
    pixelsDone_ += tile.pixels();
    if (pixelsDone_ == region_.pixels()) finishRound();
    return tile.pixels();
}

void ProgressiveImage::finishRound() {
    ++round_;
    pixelsDone_ = 0;
    if (render_.noise > 0.0 && viewer::isNoiseLookedAt(samples())) isQuiet_ = noise().relative() <= render_.noise;
}

viewer::FilmNoise ProgressiveImage::noise() const {
    viewer::FilmNoise noise;
    visitFilm([&](std::size_t, std::span<const gpu::FilmPixel> pixels) { noise += viewer::noiseOf(pixels, samples()); });
    return noise;
}

std::vector<gpu::FilmPixel> ProgressiveImage::film() const {
    std::vector<gpu::FilmPixel> pixels(region_.pixels());
    accumulate_.read(0, pixels);
    return pixels;
}

gpu::FilmPixel ProgressiveImage::filmPixel(std::size_t index) const {
    gpu::FilmPixel pixel;
    accumulate_.read(index, {&pixel, 1});
    return pixel;
}

double ProgressiveImage::roundProgress() const {
    return double(pixelsDone_) / double(std::max<std::size_t>(region_.pixels(), 1));
}

std::vector<glm::vec4> ProgressiveImage::display() {
    viewer::configureTile(batch_.view, region_, 0);
    bind();
    toneMap_.run(batch_);
    return toneMap_.display(region_.pixels());
}

void ProgressiveImage::paint(const viewer::LookSettings& look, const gpu::Texture2D& picture,
                             const ProgressiveImage* compared) {
    assert((look.look == viewer::Look::kError) == (compared != nullptr));
    viewer::configureTile(batch_.view, region_, 0);
    passes_.begin(0, 0, batch_.view, fields_, light_);  // slices show the index at the reference wavelength
    bind();
    if (compared) compared->accumulate_.bindAsCompared();
    mark("paint");
    viewer::LookSettings onDevice = look;
    onDevice.slicePosition -= middleOf(lattice_)[look.sliceAxis];
    painter_.run(batch_, onDevice, picture);
    mark({});
}

std::vector<std::pair<std::string, std::size_t>> ProgressiveImage::textures() const {
    auto rows = fields_.textures();
    append(rows, light_.textures());
    append(rows, environment_.textures());
    if (clearance_) append(rows, clearance_->textures());
    return rows;
}

std::size_t ProgressiveImage::bufferBytes() const {
    const std::size_t waiting = reflections_ ? reflections_->bytes() : 0;
    return batch_.rays.bytes() + batch_.lists.bytes() + waiting + accumulate_.filmBytes() + toneMap_.displayBytes();
}

} // namespace eikonal

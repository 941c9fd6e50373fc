#include "viewer/image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "common/accuracy.h"
#include "common/device_frame.h"
#include "common/environment_map.h"
#include "common/spectral_fields.h"
#include "viewer/fused_pipeline.h"
#include "viewer/staged_pipeline.h"

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

bool hasGreyMatter(const Fields& fields) {
    return isGrey(fields.sigmaA) && isGrey(fields.sigmaS) && isGrey(fields.anisotropyByBand) && isGrey(fields.albedo) &&
           std::all_of(fields.insets.begin(), fields.insets.end(), [](const Inset& inset) { return isGrey(inset); });
}

RenderOptions withTile(RenderOptions options, const gpu::DeviceLimits& limits) {
    options.tileRays = viewer::raysAtATime(options.tileRays, limits);
    return options;
}

viewer::MarchSettings marchSettingsOf(const Accuracy& accuracy, const InsetBounds& insets, const RenderOptions& options) {
    return {.stepVoxels = stepVoxelsOf(accuracy), .integrator = integratorOf(accuracy), .maxEvaluations = options.maxEvaluations,
            .stepsPerSlice = options.stepsPerSlice, .insets = insets};
}

std::unique_ptr<viewer::RayPipeline> pipelineFor(const gpu::Context& context, const Scene& scene, const EffectSet& effects,
                                                 std::vector<std::string> defines, const viewer::MarchSettings& settings,
                                                 const Lattice& lattice, bool hasLens, const RenderOptions& options) {
    if (options.fused && viewer::FusedPipeline::serves(defines, settings.integrator)) {
        return std::make_unique<viewer::FusedPipeline>(context, std::move(defines), settings, lattice, hasLens);
    }
    std::optional<viewer::ReflectionRules> rules;
    const int generations = scene.accuracy.reflections;
    if (viewer::Reflections::areNeeded(effects, generations)) rules = {generations, scene.accuracy.tolerance};
    return std::make_unique<viewer::StagedPipeline>(context, std::move(defines), settings, lattice, hasLens, rules, options.tileRays);
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
      batch_(context, options_.tileRays),
      pipeline_(pipelineFor(context, scene, effects, allDefines(),
                            marchSettingsOf(scene.accuracy, fields_.insetBounds(), options_), lattice_, sampling_.hasLens(),
                            options_)),
      film_(context), toneMap_(context, scene.render.toneMap), painter_(context, allDefines(), scene.render.toneMap) {
    gpu::ViewBlock& view = batch_.view;
    view.opaqueOffset = float(lattice_.voxel);
    view.minThroughput = float(options.minThroughput);
    view.sampleShare = 1.0f / float(std::max(scene.render.samples, 1));
    environment_.configure(view);
    configureLight();
    if (bake) placeLight(view, *bake, lattice_);
    if (clearance_) clearance_->configure(view);
    pipeline_->configure(view);
    setExposure(scene.render.exposureEv);
}

std::vector<std::string> ProgressiveImage::allDefines() const {
    std::vector<std::string> defines = fields_.defines();
    append(defines, environment_.defines());
    append(defines, light_.defines());
    if (clearance_) append(defines, clearance_->defines());
    return defines;
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
    film_.reserve(context_, region.pixels());
    toneMap_.reserve(context_, region.pixels());
    startOver();
}

void ProgressiveImage::setCamera(const Camera& camera) {
    camera_ = camera;
    const bool hadLens = sampling_.hasLens();
    sampling_ = viewer::samplingOf(render_, camera);
    if (sampling_.hasLens() != hadLens) pipeline_->setLens(sampling_.hasLens());
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
    pipeline_->setInsets(fields_.insetBounds());
    pipeline_->configure(batch_.view);
    startOver();
}

void ProgressiveImage::setStep(double stepVoxels, double matterVoxels) {
    pipeline_->setStep(stepVoxels, matterVoxels);
    pipeline_->configure(batch_.view);
    startOver();
}

void ProgressiveImage::setExposure(double ev) { batch_.view.exposureScale = float(std::exp2(ev)); }

void ProgressiveImage::bind() {
    fields_.bind();
    light_.bind();
    environment_.bind();
    if (clearance_) clearance_->bind();
    pipeline_->bind();
    film_.bind();
    batch_.bind();
}

void ProgressiveImage::mark(std::string_view pass) const {
    if (timer_) timer_->mark(pass);
}

void ProgressiveImage::runPass(std::size_t pass) {
    passes_.begin(pass, viewer::sampleOfRound(round_, sampling_), batch_.view, fields_, light_);
    batch_.bind();
    pipeline_->run(batch_, [this](std::string_view name) { mark(name); });
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
    film_.read(0, pixels);
    return pixels;
}

gpu::FilmPixel ProgressiveImage::filmPixel(std::size_t index) const {
    gpu::FilmPixel pixel;
    film_.read(index, {&pixel, 1});
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
    if (compared) compared->film_.bindAsCompared();
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
    return batch_.rays.bytes() + batch_.lists.bytes() + pipeline_->bytes() + film_.bytes() + toneMap_.displayBytes();
}

} // namespace eikonal
